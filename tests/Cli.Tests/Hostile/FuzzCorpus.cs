using System.Globalization;
using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Hostile;

/// <summary>Small good files of every kind, kept in memory so that each case begins with them.</summary>
public sealed class FuzzCorpus : IDisposable
{
    private readonly TemporaryFolder _folder = new();
    private readonly SortedDictionary<string, byte[]> _files = new(StringComparer.Ordinal);

    public FuzzCorpus()
    {
        FuzzTexts.WriteTo(_folder.Path);
        foreach ((string name, string format) in new[] { ("session", "png"), ("jpg", "jpg"), ("bmp", "bmp") })
        {
            Run(
                $"harvest --out {{0}}/{name} --frames 2 --seed 6 --size 80x60 --masks --semantics rays {FuzzMakers.MapOptions} --no-report "
                    + $"--image-format {format}"
            );
        }

        foreach (string command in FuzzMakers.All)
        {
            Run(command);
        }

        File.WriteAllText(_folder.PathOf("eventful/events.jsonl"), FuzzTexts.Events);
        Run("export {0}/session --format csv --shard 1/2 --out {0}/shard");
        Run("export {0}/session --format csv --shard 2/2 --out {0}/shard2");
        Directory.CreateDirectory(_folder.PathOf("maps"));
        File.Copy(_folder.PathOf("session/masks/00000000.png"), _folder.PathOf("maps/0.png"));
        File.Copy(_folder.PathOf("session/masks/00000001.png"), _folder.PathOf("maps/1.png"));
        File.Copy(_folder.PathOf("maps/0.png"), _folder.PathOf("survey/photos/a.png"));
        foreach (string file in Directory.EnumerateFiles(_folder.Path, "*", SearchOption.AllDirectories))
        {
            _files.Add(Path.GetRelativePath(_folder.Path, file), File.ReadAllBytes(file));
        }

        // Each kind is damaged where it is sound to begin with.
        foreach (FuzzKind kind in FuzzKind.All)
        {
            foreach (string command in kind.Commands)
            {
                Restore();
                CliRun run = Start(command);
                Assert.True(run.ExitCode is ExitCode.Done or ExitCode.BadData, $"{command}: {run.ExitCode}: {run.Error}");
            }
        }
    }

    internal byte[] this[FuzzKind kind] => _files[Path.Combine(kind.File.Split('/'))];

    public void Dispose() => _folder.Dispose();

    /// <summary>Runs a command on the corpus with one file in another form.</summary>
    internal CliRun Run(FuzzKind kind, byte[] content, string command)
    {
        Restore();
        File.WriteAllBytes(_folder.PathOf(kind.File), content);
        return Start(command);
    }

    /// <summary>
    /// The output that a command has left although it refused its input; null for none. An export that is interrupted by an error keeps
    /// what it has written and the journal by which it continues.
    /// </summary>
    internal string? LeftBy(CliRun run, string command) =>
        run.ExitCode != ExitCode.BadData
        || run.Error.Length == 0
        || !Directory.Exists(_folder.PathOf("out"))
        || (command.StartsWith("export ", StringComparison.Ordinal) && Directory.Exists(_folder.PathOf("out/.export")))
            ? null
            : $"{Directory.GetFiles(_folder.PathOf("out"), "*", SearchOption.AllDirectories).Length} files are left: {run.Error}";

    private void Restore()
    {
        foreach (
            string file in Directory
                .EnumerateFiles(_folder.Path, "*", SearchOption.AllDirectories)
                .Where(file => !_files.ContainsKey(Path.GetRelativePath(_folder.Path, file)))
                .ToArray()
        )
        {
            File.Delete(file);
        }

        if (Directory.Exists(_folder.PathOf("out")))
        {
            Directory.Delete(_folder.PathOf("out"), recursive: true);
        }

        foreach ((string name, byte[] content) in _files)
        {
            string path = _folder.PathOf(name);
            if (!File.Exists(path) || !File.ReadAllBytes(path).AsSpan().SequenceEqual(content))
            {
                Directory.CreateDirectory(Path.GetDirectoryName(path)!);
                File.Delete(path);
                File.WriteAllBytes(path, content);
            }
        }
    }

    private void Run(string command)
    {
        CliRun run = Start(command);
        Assert.True(run.ExitCode == ExitCode.Done, $"{command}: {run.Error}");
    }

    private CliRun Start(string command) =>
        HostileSession.Run([.. command.Split(' ').Select(word => string.Format(CultureInfo.InvariantCulture, word, _folder.Path))]);
}
