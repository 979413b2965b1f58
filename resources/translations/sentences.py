"""The sentences that a C++ file makes: chains of literals and values joined by +, and formats of printf.

A value becomes %1, %2, ...: `path + ": can't be read (" + why + ")"` is the sentence "%1: can't be read (%2)".
"""
import re

TOKEN = re.compile(
    r'(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<line>^[ \t]*#(?:[^\n\\]|\\.|\\\n)*)|(?P<raw>R"(?P<mark>[^(]*)\(.*?\)(?P=mark)")'
    r'|(?P<text>"(?:[^"\\\n]|\\.)*")|(?P<char>\'(?:[^\'\\\n]|\\.)+\')|(?P<name>[A-Za-z_]\w*|\d[\w.\']*)'
    r'|(?P<sign>::|->|\+=|\+\+|==|!=|<=|>=|&&|\|\||<<|>>|[^\s\w])', re.S | re.M)
OPENING = {"(": ")", "[": "]", "{": "}"}
SEPARATORS = set(", ; ? : = == != <= >= && || += << >> ! return throw case else constexpr const auto".split())
ESCAPES = {"n": "\n", "t": "\t", '"': '"', "'": "'", "\\": "\\"}
FORMAT = re.compile(r"%(?:%|[-+0#]*[\d.*]*(?:hh|h|ll|l|z)?[diufgsc])")


def spoken(literal):
    """What a literal of the source says."""
    return re.sub(r"\\(.)", lambda match: ESCAPES.get(match.group(1), match.group(0)), literal[1:-1])


def tree_of(source):
    """Tokens (kind, text); what is in brackets is a group of its own: ("group", [tokens])."""
    groups = [[]]
    for match in TOKEN.finditer(source):
        kind, text = match.lastgroup, match.group(0)
        kind = "raw" if kind == "mark" else kind
        if kind in ("comment", "line", "raw"):
            continue
        if text in OPENING:
            groups.append([])
        elif text in OPENING.values() and len(groups) > 1:
            done = groups.pop()
            groups[-1].append(("group", done))
        else:
            groups[-1].append((kind, text))
    return groups[0]


def literal_of(operand):
    """What an operand says if it is a literal, also as std::string("..."); None where it is a value."""
    while operand and operand[-1][0] == "group" and [text for _, text in operand[:-1]] in (["std", "::", "string"], []):
        operand = operand[-1][1]
    if operand and all(kind in ("text", "char") for kind, _ in operand):
        return "".join(spoken(text) for _, text in operand)
    return None


def chain_of(tokens):
    """The sentence of operands joined by +; "" where no literal is among them."""
    operands = [[]]
    for token in tokens:
        operands.append([]) if token == ("sign", "+") else operands[-1].append(token)
    said = [literal_of(operand) for operand in operands]
    if all(text is None for text in said):
        return ""
    sentence, number = "", 0
    for text in said:
        number += text is None
        sentence += f"%{number}" if text is None else text.replace("%", "%%") if len(said) > 1 else text
    return numbered(sentence) if len(said) == 1 else sentence.replace("%%", "%")


def numbered(text):
    """A format of printf with %1, %2, ... for its values."""
    number = 0

    def value(match):
        nonlocal number
        number += match.group(0) != "%%"
        return "%" if match.group(0) == "%%" else f"%{number}"

    return FORMAT.sub(value, text)


def is_table_entry(group):
    """{"name", &Type::member, ..., "meaning"}: a field with its description, which no message has."""
    return [kind for kind, _ in group[:1]] == ["text"] and ("sign", "&") in group


def sentences_of(source, of="all"):
    """The sentences of a file, or those `of` "errors", which an Error is made of, or the "marked" ones alone:
    PELLUCIDA_WORDS("..."), with which also a single word counts."""
    found = set()

    def walk(tokens, heard, marked):
        part, caller = [], ""
        for token in tokens + [("sign", ";")]:
            kind, text = token
            is_counted = kind == "group" and caller == "string" and literal_of(text) is not None
            if kind == "group" and not is_table_entry(text) and not is_counted:
                walk(text, heard or (of == "errors" and caller.endswith("Error")), caller == "PELLUCIDA_WORDS")
            if kind != "group" and text in SEPARATORS:
                chain = chain_of(part) if part else ""
                if chain and (marked or (heard and is_prose(chain))):
                    found.add(chain)
                part = []
            else:
                part.append(token)
            caller = text if kind == "name" else ""

    walk(tree_of(source), of == "all", False)
    return found


def is_prose(text):
    """Two words at least, or one that joins what stands beside it; neither markup nor lines of a file."""
    words = re.sub(r"%\d", " ", text)
    return bool(re.search(r"[A-Za-z]{3,}|\bto\b", words)) and " " in text and not re.search(r"[<>\n`]|//", text)
