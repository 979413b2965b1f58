#include <ostream>

#include "pellucida/core/Table.h"
#include "pellucida/evaluation/TrialSummary.h"

namespace pellucida {

void write_trials_csv(std::ostream& stream, std::span<const TrialOutcome> outcomes) {
  stream << "operator,modality,seed,success,punctured,deposited,removed";
  for (const TrialMetric& metric : trial_metrics()) stream << ',' << metric.name;
  stream << ",lost_pL,limits\n";
  for (const TrialOutcome& outcome : outcomes) {
    stream << "simulated," << csv_cell(name_of(outcome.modality)) << ',' << outcome.seed << ',' << outcome.success
           << ',' << outcome.punctured << ',' << outcome.deposited << ',' << outcome.removed;
    for (const TrialMetric& metric : trial_metrics()) stream << ',' << csv_number(outcome.*metric.value);
    stream << ',' << csv_number(outcome.lost_pL) << ',' << csv_cell(limits_text(outcome.limits)) << '\n';
  }
}

void write_summary_csv(std::ostream& stream, std::span<const ModalitySummary> summaries) {
  stream << "operator,modality,metric,count,median,mean,mean_lower,mean_upper\n";
  for (const ModalitySummary& summary : summaries) {
    const std::string start = "simulated," + csv_cell(name_of(summary.modality)) + ',';
    for (std::size_t k = 0; k < summary.metrics.size(); ++k) {
      const Estimate& e = summary.metrics[k];
      stream << start << trial_metrics()[k].name << ',' << e.count << ',' << csv_number(e.median) << ','
             << csv_number(e.mean) << ',' << csv_number(e.lower) << ',' << csv_number(e.upper) << '\n';
    }
    const Share& s = summary.success;
    stream << start << "success_ratio," << summary.count << ",," << csv_number(s.value) << ',' << csv_number(s.lower)
           << ',' << csv_number(s.upper) << '\n';
  }
}

}  // namespace pellucida
