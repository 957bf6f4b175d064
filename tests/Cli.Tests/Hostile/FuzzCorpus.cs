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
        foreach ((string name, string format) in new[] { ("session", "png"), ("jpg", "jpg"), ("bmp", "bmp") })
        {
            Run($"harvest --out {{0}}/{name} --frames 2 --seed 5 --size 80x60 --masks --no-report --image-format {format}");
        }

        foreach (string format in (string[])["csv", "coco", "coco-panoptic", "kitti", "voc", "yolo", "webdataset"])
        {
            Run($"export {{0}}/session --format {format} --out {{0}}/{format}");
        }

        Run("export {0}/session --format csv --shard 1/2 --out {0}/shard");
        Run("export {0}/session --format csv --shard 2/2 --out {0}/shard2");
        Directory.CreateDirectory(_folder.PathOf("maps"));
        File.Copy(_folder.PathOf("session/masks/00000000.png"), _folder.PathOf("maps/0.png"));
        File.Copy(_folder.PathOf("session/masks/00000001.png"), _folder.PathOf("maps/1.png"));
        Directory.CreateDirectory(_folder.PathOf("survey/photos"));
        _folder.File("survey/spaces.csv", "prop_sign_road_01a,-949234773,sign,STOP,R1-1,0,-0.5,-0.04,3,0.5,-0.06,1.5,-y,measured,a test\n");
        _folder.File("survey/photos.csv", "file,model,x,y,z,pitch,roll,yaw,verticalFov\na.png,prop_sign_road_01a,0,-3,2,0,0,0,50\n");
        File.Copy(_folder.PathOf("maps/0.png"), _folder.PathOf("survey/photos/a.png"));
        _folder.File("points.csv", "0,5,0\n1.5,20,-3\n");
        _folder.File("vehicles.csv", "10,20,0,90\n-5,3,0,0,12\n");
        _folder.File("lens.txt", "FocalScale = 1.1\nCentreOffsetX = 0.01\nCentreOffsetY = 0\nK1 = 0.05\nK2 = 0\n");
        _folder.File("boxes.json", """
            {"camera": {"position": [0, 0, 0], "rotation": [0, 0, 0], "verticalFovDegrees": 50, "width": 80, "height": 60},
             "cuboids": [{"name": "a", "centre": [0, 10, 0], "halfExtents": [1, 2, 1], "rotation": [0, 0, 30]}]}
            """);
        _folder.File("GtaDataHarvester.log", "2026-01-01 10:00:00 GtaDataHarvester 1.0.0, API v3.6.0, game 1.0.3095.0\n2026-01-01 10:00:01 "
            + "Harvest started.\n");
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

    private void Restore()
    {
        foreach (string file in Directory.EnumerateFiles(_folder.Path, "*", SearchOption.AllDirectories)
            .Where(file => !_files.ContainsKey(Path.GetRelativePath(_folder.Path, file))).ToArray())
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
