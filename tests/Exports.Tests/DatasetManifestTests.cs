using Harvester.Datasets.Files;
using Harvester.Exports.Validation;
using Harvester.Sessions.Files;
using Harvester.Sessions.Reading;
using Harvester.Sessions.Reading.Files;
using Harvester.TestSupport;

namespace Harvester.Exports.Tests;

/// <summary>The manifest of a dataset, and what validate finds with it.</summary>
[Collection(SimulatedSession.Collection)]
public sealed class DatasetManifestTests(SimulatedSession simulated) : ExportTests
{
    private const int Seed = 20_261_123;

    private static readonly ExportOptions Copied = new() { Images = ImageTransfer.Copy };

    private string ManifestFile => Folder.PathOf("out/manifest.jsonl");

    [Theory]
    [MemberData(nameof(DatasetExporterTests.Formats), MemberType = typeof(DatasetExporterTests))]
    public void Manifest_has_every_file_with_its_digest(string format)
    {
        Folder.Export(format, simulated.OpenFor(format), DatasetExporterTests.SplitsOf(format));

        string[] files = [.. Folder.Contents("out").Keys.Where(name => name != "manifest.jsonl")];
        Assert.Equal(
            files.Select(name => Manifest.FileLine(name, FileDigest.OfFile(Folder.PathOf("out/" + name)))),
            Folder
                .Lines("out/manifest.jsonl")
                .OrderBy(line => line[..line.IndexOf("\",", StringComparison.Ordinal)], StringComparer.Ordinal)
        );
        Assert.Contains($"\"files\":{files.Length},", File.ReadAllText(Folder.PathOf("out/export.json")), StringComparison.Ordinal);
    }

    [Theory]
    [MemberData(nameof(DatasetExporterTests.Formats), MemberType = typeof(DatasetExporterTests))]
    public void Validate_notices_a_flipped_bit_in_a_file_of_each_kind(string format) => FlipBits(format, OneOfEachKind);

    [Theory]
    [MemberData(nameof(DatasetExporterTests.Formats), MemberType = typeof(DatasetExporterTests))]
    [Trait("Category", "Heavy")]
    public void Validate_notices_a_flipped_bit_in_any_file(string format) => FlipBits(format, names => names);

    [Theory]
    [MemberData(nameof(DatasetExporterTests.Formats), MemberType = typeof(DatasetExporterTests))]
    public void Validate_notices_a_missing_file_of_each_kind(string format) => RemoveFiles(format, OneOfEachKind);

    [Theory]
    [MemberData(nameof(DatasetExporterTests.Formats), MemberType = typeof(DatasetExporterTests))]
    [Trait("Category", "Heavy")]
    public void Validate_notices_any_missing_file(string format) => RemoveFiles(format, names => names);

    [Fact]
    public void Damage_of_an_image_of_the_session_is_noticed_in_the_export()
    {
        string session = Folder.PathOf("session");
        CopySession(session);
        string image = Directory.GetFiles(Path.Combine(session, "frames")).Order(StringComparer.Ordinal).First();
        byte[] bytes = File.ReadAllBytes(image);
        bytes[^20] ^= 1;
        File.WriteAllBytes(image, bytes);

        Folder.Export("yolo", new SessionReader(session));

        Assert.Equal(
            "images/train/00000000.png: it is damaged: its SHA-256 differs from manifest.jsonl.",
            Assert.Single(Validate().Problems).ToString()
        );
    }

    [Fact]
    public void Export_of_a_session_without_manifest_has_one()
    {
        string session = Folder.PathOf("session");
        CopySession(session);
        File.Delete(Path.Combine(session, "manifest.jsonl"));

        Folder.Export("yolo", new SessionReader(session));
        Folder.Export("yolo", simulated.Open(), to: "usual");

        Assert.Equal(Folder.Contents("usual")["manifest.jsonl"].Length, Folder.Contents("out")["manifest.jsonl"].Length);
        Assert.Empty(Validate().Problems);
    }

    [Fact]
    public void File_of_a_listed_kind_is_too_many()
    {
        Folder.Export("yolo", simulated.Open());
        File.Copy(Folder.PathOf("out/images/train/00000000.png"), Folder.PathOf("out/images/train/copy.PNG"));
        File.Copy(Folder.PathOf("out/labels/train/00000000.txt"), Folder.PathOf("out/labels/train/copy.txt"));

        string[] problems = [.. Validate().Problems.Select(problem => problem.ToString())];

        const string message = "it is not listed in manifest.jsonl, but readers take it for a part of the dataset. Delete it.";
        Assert.Equal(
            [$"images/train/copy.PNG: {message}", $"labels/train/copy.txt: {message}"],
            problems.Where(problem => problem.EndsWith(message, StringComparison.Ordinal))
        );
    }

    [Fact]
    public void Files_that_readers_ignore_are_no_problem()
    {
        Folder.Export("yolo", simulated.Open());
        File.WriteAllText(Folder.PathOf("out/NOTES.md"), "mine");
        File.WriteAllText(Folder.PathOf("out/labels/train.cache"), "of a training");

        DatasetValidation validation = Validate();

        Assert.Empty(validation.Problems);
        Assert.Equal(["NOTES.md", "labels/train.cache"], validation.OtherFiles);
    }

    [Fact]
    public void Lines_missing_from_the_manifest_are_noticed()
    {
        Folder.Export("voc", simulated.Open());
        string[] lines = File.ReadAllLines(ManifestFile);
        File.WriteAllLines(ManifestFile, lines[..^3]);

        Assert.Equal(
            $"manifest.jsonl: it lists {lines.Length - 3} files, but export.json counts {lines.Length}.",
            Assert.Single(Validate().Problems).ToString()
        );
    }

    [Fact]
    public void Damaged_line_of_the_manifest_is_named()
    {
        Folder.Export("voc", simulated.Open());
        string[] lines = File.ReadAllLines(ManifestFile);
        lines[2] = lines[2].Replace("\"bytes\":", "\"bites\":", StringComparison.Ordinal);
        File.WriteAllLines(ManifestFile, lines);

        Assert.StartsWith("manifest.jsonl, line 3: ", Assert.Single(Validate().Problems).ToString(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("../session.json")]
    [InlineData("/etc/passwd")]
    public void File_outside_the_dataset_is_not_read(string path)
    {
        Folder.Export("voc", simulated.Open());
        File.AppendAllText(ManifestFile, Manifest.FileLine(path, FileDigest.Of("")) + "\n");

        Assert.Contains(
            Validate().Problems,
            problem => problem.File == path && problem.Message.Contains("points outside", StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Deleted_manifest_is_a_problem()
    {
        Folder.Export("voc", simulated.Open());
        File.Delete(ManifestFile);

        Assert.Equal("manifest.jsonl: it is missing, but export.json counts its files.", Assert.Single(Validate().Problems).ToString());
    }

    [Fact]
    public void Dataset_of_an_earlier_version_needs_no_manifest()
    {
        Folder.Export("voc", simulated.Open());
        File.Delete(ManifestFile);
        string header = Folder.PathOf("out/export.json");
        string text = File.ReadAllText(header);
        int files = text.IndexOf("\"files\":", StringComparison.Ordinal);
        File.WriteAllText(header, text.Remove(files, text.IndexOf(',', files) + 1 - files));

        DatasetValidation validation = Validate();

        Assert.Empty(validation.Problems);
        Assert.False(validation.HasManifest);
    }

    private static IEnumerable<string> OneOfEachKind(IEnumerable<string> names) =>
        names.GroupBy(name => (Path.GetDirectoryName(name), Path.GetExtension(name))).Select(kind => kind.Last());

    private void FlipBits(string format, Func<IEnumerable<string>, IEnumerable<string>> choose)
    {
        Folder.Export(format, simulated.OpenFor(format), Copied);
        var random = new Random(Seed);
        foreach (string name in choose(Folder.Contents("out").Keys).ToArray())
        {
            byte[] bytes = File.ReadAllBytes(Folder.PathOf("out/" + name));
            if (bytes.Length > 0)
            {
                int bit = random.Next(bytes.Length * 8);
                Flip(name, bit);
                Assert.True(IsRefused(), $"{name}: bit {bit}");
                Flip(name, bit);
            }
        }

        Assert.Empty(Validate().Problems);
    }

    private void RemoveFiles(string format, Func<IEnumerable<string>, IEnumerable<string>> choose)
    {
        Folder.Export(format, simulated.OpenFor(format));
        foreach (string name in choose(Folder.Contents("out").Keys.Where(name => name != "export.json")).ToArray())
        {
            File.Move(Folder.PathOf("out/" + name), Folder.PathOf("away"));
            Assert.True(IsRefused(), name);
            File.Move(Folder.PathOf("away"), Folder.PathOf("out/" + name));
        }
    }

    private DatasetValidation Validate() => DatasetValidator.Validate(Folder.PathOf("out"));

    private bool IsRefused()
    {
        try
        {
            return Validate().Problems.Count > 0;
        }
        catch (DatasetFormatException)
        {
            return true;
        }
    }

    private void Flip(string name, int bit)
    {
        string path = Folder.PathOf("out/" + name);
        byte[] bytes = File.ReadAllBytes(path);
        bytes[bit / 8] ^= (byte)(1 << (bit % 8));
        File.WriteAllBytes(path, bytes);
    }

    private void CopySession(string to)
    {
        foreach (string file in Directory.EnumerateFiles(simulated.Folder, "*", SearchOption.AllDirectories))
        {
            string copy = Path.Combine(to, Path.GetRelativePath(simulated.Folder, file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }
    }
}
