using Harvester.Sessions.Reading;

namespace Harvester.Exports.Formats.Kitti;

/// <summary>Checks the file of the inertial unit at a frame: one line of 30 numbers.</summary>
internal static class KittiOxtsCheck
{
    private const int Values = 30;

    public static IEnumerable<SessionProblem> Problems(DatasetContent dataset, string name)
    {
        (int Number, string Text)[] lines = [.. dataset.Lines(name)];
        if (lines.Length != 1)
        {
            yield return new SessionProblem(name, null, dataset.Has(name) ? "it does not have one line." : "it is missing.");
        }
        else if (Numbers.Parse(lines[0].Text.Split(' ')) is not { Length: Values })
        {
            yield return new SessionProblem(name, 1, $"it does not have {Values} numbers.");
        }
    }
}
