using System.Globalization;
using Harvester.Cli.Terminals;
using Harvester.Cli.Tests.Repetition;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>
/// The smallest good files of every kind: one or two frames of 64 x 48 pixels and a road of three nodes, so that a case takes about a
/// millisecond. Each worker has a copy.
/// </summary>
public sealed class FuzzReaderCorpus : IDisposable
{
    private static readonly string Small =
        $"--seed 5 --size 64x48 --masks --semantics rays {FuzzMakers.MapOptions} --no-report " + "--roads {0}/roads.csv";

    private readonly TemporaryFolder _folder = new();

    public FuzzReaderCorpus()
    {
        Directory.CreateDirectory(Origin);
        FuzzTexts.WriteTo(Origin);
        File.WriteAllText(PathOf("roads.csv"), WritingCommand.Roads);
        foreach ((string name, string format) in new[] { ("session", "png"), ("jpg", "jpg"), ("bmp", "bmp") })
        {
            // The first frame has no flow.
            Run($"harvest --out {{0}}/{name} --frames 2 --places 1 {Small} --image-format {format}");
        }

        Run($"harvest --out {{0}}/two --frames 2 {Small} --no-scenes");
        foreach (string command in FuzzMakers.All)
        {
            Run(command);
        }

        Run("export {0}/two --format csv --shard 1/2 --out {0}/shard");
        Run("export {0}/two --format csv --shard 2/2 --out {0}/shard2");
        File.Move(PathOf("roads.csv"), PathOf("session/scenes/roads.csv"));
        Directory.CreateDirectory(PathOf("maps"));
        File.Copy(PathOf("session/masks/00000000.png"), PathOf("maps/0.png"));
        File.Copy(PathOf("maps/0.png"), PathOf("survey/photos/a.png"));

        Assert.Contains("\"joint\":", File.ReadAllText(PathOf("people/labels.jsonl")), StringComparison.Ordinal);

        // A reader that refused the sound file would prove nothing of damaged ones.
        Assert.All(FuzzKind.All, kind => kind.Read(Origin));
        Directory.Delete(PathOf("merged"), recursive: true);
    }

    private string Origin => _folder.PathOf("origin");

    public void Dispose() => _folder.Dispose();

    /// <summary>The folder of a worker: a copy of all files, made once, because copying takes longer than many cases.</summary>
    internal string FolderOf(int worker)
    {
        string copy = _folder.PathOf(string.Create(CultureInfo.InvariantCulture, $"worker-{worker}"));
        if (!Directory.Exists(copy))
        {
            Folders.Copy(Origin, copy);
        }

        return copy;
    }

    /// <summary>The sound file of a kind.</summary>
    internal byte[] Sound(FuzzKind kind) => File.ReadAllBytes(PathOf(kind.File));

    private string PathOf(string name) => Path.Combine(Origin, name);

    private void Run(string command)
    {
        CliRun run = HostileSession.Run([.. command.Split(' ').Select(word => string.Format(CultureInfo.InvariantCulture, word, Origin))]);
        Assert.True(run.ExitCode == ExitCode.Done, $"{command}: {run.Error}");
    }
}
