using System;
using System.IO;
using System.Linq;
using Harvester.Datasets.Exports.Validation;
using Harvester.Datasets.Files;
using Harvester.Datasets.Sharding;
using Harvester.Evaluation.Figures;
using Harvester.Sessions.Files;

namespace Harvester.Cli.Driving;

/// <summary>
/// The folder over which a game is driven. The bridge writes to it and deletes in it, so that a folder of something else is refused.
/// </summary>
internal static class BridgeFolder
{
    /// <summary>Name of the shared folder in the folder of the drive, where no other is named.</summary>
    public const string DefaultName = "bridge";

    private const string Picture = "frame_";

    // What the game and its client write, under these names or temporary ones made of them; docs/bridge.md. Pictures are no sign: other
    // tools number theirs so too.
    private static readonly string[] Signs = ["state.txt", "indicators.txt", "controls.txt", "command.json", "alive.txt"];

    /// <summary>Checks that a bridge may be opened in a folder, and changes nothing.</summary>
    /// <exception cref="OccupiedFolderException">The folder holds something else.</exception>
    public static void Check(string folder)
    {
        if (!Directory.Exists(folder))
        {
            return;
        }

        string[] found = [.. Directory.EnumerateFileSystemEntries(folder).Select(entry => Path.GetFileName(entry))
            .Where(name => !name.StartsWith('.')).Order(StringComparer.Ordinal)];
        bool isOther = SessionMerger.IsSession(folder) || DatasetValidator.IsDataset(folder) || found.Contains(DriveRecord.FileName);
        if (found.Length > 0 && (isOther || !found.Any(IsSign)))
        {
            string foreign = found.FirstOrDefault(name => !IsSign(name) && !name.StartsWith(Picture, StringComparison.Ordinal)) ?? found[0];
            throw new OccupiedFolderException($"'{folder}' holds other files than those of a bridge, e.g. '{foreign}'. Name another folder with --folder.");
        }
    }

    private static bool IsSign(string name) =>
        Signs.Any(sign => name.Contains(sign, StringComparison.Ordinal))
        || (name.StartsWith(Picture, StringComparison.Ordinal) && AtomicFile.TargetOf(name) is not null);
}
