using Harvester.Datasets.Files;
using Harvester.Datasets.Sharding;
using Harvester.Driving.Bridge;
using Harvester.Runs.Evaluation.Scores;
using Harvester.Sessions.Files;

namespace Harvester.Runs.Driving;

/// <summary>
/// Checks the folder of a folder bridge. The bridge writes and deletes files there, so a folder with other files is refused.
/// </summary>
public static class BridgeFolder
{
    /// <summary>Default name of the shared folder, in the folder of the drive.</summary>
    public const string DefaultName = "bridge";

    private const string Picture = "frame_";

    /// <summary>What the names of the locks beside the shared folder begin with; killed processes leave them.</summary>
    private const string DefaultLock = $".{DefaultName}.harvester-lock";

    // Files that game and client write, under these names or temporary names derived from them; docs/bridge.md. Images do not identify a
    // bridge, because other tools use the same names.
    private static readonly string[] Signs =
    [
        BridgeProtocol.HelloFile,
        "state.txt",
        "indicators.txt",
        "controls.txt",
        "command.json",
        "alive.txt",
    ];

    /// <summary>Whether a name in the folder of a drive is that of the shared folder in its default place, or of its lock.</summary>
    public static bool IsDefault(string name) => name == DefaultName || name.StartsWith(DefaultLock, StringComparison.Ordinal);

    /// <summary>Whether a shared folder has its default place in the folder of the drive.</summary>
    /// <param name="output">The folder of the drive.</param>
    /// <param name="folder">The shared folder.</param>
    public static bool IsDefaultIn(string output, string folder) =>
        Path.TrimEndingDirectorySeparator(Path.GetFullPath(folder)) == Path.Combine(Path.GetFullPath(output), DefaultName);

    /// <summary>Checks that a bridge may be opened in a folder. Changes nothing.</summary>
    /// <exception cref="OccupiedFolderException">The folder has files that are not a bridge's.</exception>
    public static void Check(string folder)
    {
        if (!Directory.Exists(folder))
        {
            return;
        }

        string[] found =
        [
            .. Directory
                .EnumerateFileSystemEntries(folder)
                .Select(entry => Path.GetFileName(entry))
                .Where(name => !name.StartsWith('.'))
                .Order(StringComparer.Ordinal),
        ];
        bool isOther = SessionMerger.IsSession(folder) || new DatasetFolder(folder).IsFinished || found.Contains(DriveRecord.FileName);
        if (found.Length > 0 && (isOther || !found.Any(IsSign)))
        {
            string foreign = found.FirstOrDefault(name => !IsSign(name) && !name.StartsWith(Picture, StringComparison.Ordinal)) ?? found[0];
            throw new OccupiedFolderException(
                $"'{folder}' has files that are not a bridge's, e.g. '{foreign}'. Name another folder with --folder."
            );
        }
    }

    private static bool IsSign(string name) =>
        Signs.Any(sign => name.Contains(sign, StringComparison.Ordinal))
        || (name.StartsWith(Picture, StringComparison.Ordinal) && AtomicFile.TargetOf(name) is not null);
}
