using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Harvester.Datasets.Diagnosis;

/// <summary>Reports a log of the mod without a single line that the mod wrote, which would otherwise count as free of problems.</summary>
internal static class EntryCheck
{
    private static readonly Regex Entry = new(@"^\d{4}-\d\d-\d\d \d\d:\d\d:\d\d ", RegexOptions.CultureInvariant);

    public static IEnumerable<Finding> Of(LogFile log) =>
        log.Runs.SelectMany(run => run).Any(line => Entry.IsMatch(line.Text))
            ? []
            : [new Finding(
                $"{LogFile.NameOf(LogKind.Mod)} has no line that the mod wrote: it is empty, damaged or another program's.",
                "Start the game once more and read the log then; if it stays empty, look whether the disk is full and the folder scripts may be written to.")];
}
