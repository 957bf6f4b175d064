using System.Globalization;
using System.Text.RegularExpressions;

namespace Harvester.Sessions.Text;

/// <summary>
/// Texts of a JSON file that stand for numbers: the name of a parameter after a dollar sign, then optionally a factor and a term to add, as
/// in $speed*0.5+2.
/// </summary>
/// <param name="values">The values of the parameters.</param>
internal sealed class NumberTerms(IReadOnlyDictionary<string, double> values)
{
    private const string Number = @"[0-9]{1,6}(?:\.[0-9]{1,6})?";
    private static readonly Regex Form = new(
        $@"\A\$(?<name>[A-Za-z][A-Za-z0-9]{{0,29}})(?:\*(?<factor>-?{Number}))?(?<term>[+-]{Number})?\z",
        RegexOptions.CultureInvariant
    );

    /// <summary>The number that a text stands for; null if it is none.</summary>
    public double? ValueOf(string text)
    {
        Match match = Form.Match(text);
        return match.Success && values.TryGetValue(match.Groups["name"].Value, out double value)
            ? (value * Of(match.Groups["factor"], 1)) + Of(match.Groups["term"], 0)
            : null;
    }

    private static double Of(Group group, double otherwise) =>
        group.Success ? double.Parse(group.Value, CultureInfo.InvariantCulture) : otherwise;
}
