"""Opens session.pvd in ParaView and holds its force array over time against what a session must have."""
import sys

from paraview import servermanager
from paraview.simple import PVDReader


def surfaces(data):
    """The polygon data sets of a (composite) data set that carry forces."""
    if data is None:
        return []
    if data.IsA("vtkCompositeDataSet"):
        found = []
        iterator = data.NewIterator()
        iterator.InitTraversal()
        while not iterator.IsDoneWithTraversal():
            found += surfaces(iterator.GetCurrentDataObject())
            iterator.GoToNextItem()
        return found
    return [data] if data.IsA("vtkDataSet") and data.GetPointData().HasArray("force_uN") else []


def main():
    reader = PVDReader(FileName=sys.argv[1])
    times = list(reader.TimestepValues)
    assert len(times) > 100, "only %d steps" % len(times)
    assert all(later > earlier for earlier, later in zip(times, times[1:])), "time does not rise"

    peaks_uN = []
    for time_s in times[:: max(1, len(times) // 12)] + [times[-1]]:
        reader.UpdatePipeline(time_s)
        found = surfaces(servermanager.Fetch(reader))
        assert found, "no surface with force_uN at %.2f s" % time_s
        array = found[0].GetPointData().GetArray("force_uN")
        assert array.GetNumberOfComponents() == 3
        peaks_uN.append(array.GetRange(-1)[1])
    print("largest nodal force (uN) over time:", " ".join("%.3f" % value for value in peaks_uN))
    assert max(peaks_uN) > 3 * min(peaks_uN) + 0.01, "the force does not change over time"


main()
