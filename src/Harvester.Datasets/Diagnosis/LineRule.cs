using System.Text.RegularExpressions;

namespace Harvester.Datasets.Diagnosis;

/// <summary>A problem that single lines of a log show.</summary>
/// <param name="pattern">A regular expression that matches such a line; the cause may refer to its groups, as in $1.</param>
/// <param name="cause">The cause, one sentence.</param>
/// <param name="advice">What to do about it.</param>
internal sealed class LineRule(string pattern, string cause, string advice)
{
    private readonly Regex _pattern = new(pattern, RegexOptions.IgnoreCase | RegexOptions.CultureInvariant);

    /// <summary>
    /// A finding for each rule that lines match. A line counts only for the first matching rule, so specific rules must precede general
    /// ones.
    /// </summary>
    public static IEnumerable<Finding> Apply(IReadOnlyList<LineRule> rules, IEnumerable<LogLine> lines) =>
        from line in lines
        let rule = rules.FirstOrDefault(rule => rule._pattern.IsMatch(line.Text))
        where rule is not null
        group rule.FindingOf(line) by rule into found
        select found.Last() with
        {
            Count = found.Count(),
        };

    private Finding FindingOf(LogLine line) => new(_pattern.Match(line.Text).Result(cause), advice, line);
}
