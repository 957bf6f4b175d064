using System.Text.RegularExpressions;

namespace Harvester.Datasets.Diagnosis;

/// <summary>Reports a log of the mod without a line written by the mod, which would otherwise seem to have no problems.</summary>
internal static class EntryCheck
{
    private static readonly Regex Entry = new(@"^\d{4}-\d\d-\d\d \d\d:\d\d:\d\d ", RegexOptions.CultureInvariant);

    public static IEnumerable<Finding> Of(LogFile log) =>
        log.Runs.SelectMany(run => run).Any(line => Entry.IsMatch(line.Text))
            ? []
            :
            [
                new Finding(
                    $"{LogFile.NameOf(LogKind.Mod)} has no line of the mod: it is empty, damaged, or the log of another program.",
                    "Start the game again, then read the log. If it stays empty, check for a full disk and for write access to the folder "
                        + "'scripts'."
                ),
            ];
}
