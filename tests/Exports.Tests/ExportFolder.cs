using Harvester.Exports.Assembly;
using Harvester.Exports.Formats;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;

namespace Harvester.Exports.Tests;

/// <summary>Folders for exports that are gone after the test.</summary>
internal sealed class ExportFolder : IDisposable
{
    private readonly string _root = Directory.CreateTempSubdirectory("harvester-test-").FullName;

    public string PathOf(string name) => Path.Combine(_root, name);

    public string[] Lines(string name) => File.ReadAllLines(PathOf(name));

    public ExportResult Export(
        string format,
        SessionReader session,
        ExportOptions? options = null,
        string to = "out",
        Shard? shard = null,
        SyncMode sync = SyncMode.Never
    ) => Export(format, [session], options, to, shard, sync);

    /// <summary>Exports; by default without waiting for the disk, which takes most of the time of a small export.</summary>
    public ExportResult Export(
        string format,
        IReadOnlyList<SessionReader> sessions,
        ExportOptions? options = null,
        string to = "out",
        Shard? shard = null,
        SyncMode sync = SyncMode.Never
    ) => new DatasetExporter(Plan(format, sessions, options), PathOf(to), shard ?? Shard.Whole, sync).Run(_ => { });

    public static ExportPlan Plan(string format, IReadOnlyList<SessionReader> sessions, ExportOptions? options = null) =>
        new(DatasetFormats.Find(format)!, sessions, options ?? new ExportOptions());

    /// <summary>Every file below a folder with its bytes.</summary>
    public SortedDictionary<string, string> Contents(string name)
    {
        var contents = new SortedDictionary<string, string>(StringComparer.Ordinal);
        foreach (string file in Directory.EnumerateFiles(PathOf(name), "*", SearchOption.AllDirectories))
        {
            contents.Add(Path.GetRelativePath(PathOf(name), file), Convert.ToHexString(File.ReadAllBytes(file)));
        }

        return contents;
    }

    public void Dispose() => Directory.Delete(_root, recursive: true);
}
