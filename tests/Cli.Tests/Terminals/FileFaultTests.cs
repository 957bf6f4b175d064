using Harvester.Cli.Terminals;

namespace Harvester.Cli.Tests.Terminals;

public sealed class FileFaultTests : IDisposable
{
    private const string Point = "project --position 0,0,0 --rotation 0,0,0 --fov 50 --size 80x60 --points";

    private readonly TemporaryFolder _folder = new();

    public FileFaultTests()
    {
        Directory.CreateDirectory(_folder.PathOf("folder"));
        _folder.File("file", "mine");
        _folder.File(
            "session.json",
            """{ "formatVersion": 1, "game": "simulation", "image": { "width": 80, "height": 60 }, "counters": { "captured": 0 } }"""
        );
    }

    public void Dispose() => _folder.Dispose();

    [Theory]
    [InlineData("boxes {folder}", "'{folder}' is a folder where a file is expected, or access to it is denied. Name another path.")]
    [InlineData("boxes {none}", "File not found: '{none}'.")]
    [InlineData(Point + " {folder}", "'{folder}' is a folder where a file is expected, or access to it is denied. Name another path.")]
    [InlineData(Point + " {none}/points.csv", "Folder not found: '{none}'.")]
    [InlineData(Point + " {none}/o'brien/points.csv", "Folder not found: '{none}/o'brien'.")]
    [InlineData("lanes --position 0,0,0 --heading 0 --roads {none}", "File not found: '{none}'.")]
    [InlineData("roads info {none}", "File not found: '{none}'.")]
    [InlineData("spaces check {none}", "File not found: '{none}'.")]
    [InlineData("report {.} --out {none}/page.html", "Folder not found: '{none}'.")]
    [InlineData("report {file}", "'{file}' is a file. Name the folder of a session.")]
    [InlineData("export {.} --format csv --out {file}", "'{file}' is a file. Name a folder with --out.")]
    [InlineData("export {.} --format csv --out {file}/below", "'{file}' is a file. Name a folder with --out.")]
    public void Missing_file_or_folder_is_reported_in_one_line_with_advice(string command, string message)
    {
        string[] words = [.. command.Split(' ').Select(InFolder)];

        CliRun run = CliRun.Of(words);

        Assert.Equal((ExitCode.InputOutput, $"harvester: {InFolder(message)}\n"), (run.ExitCode, run.Error));
    }

    [Theory]
    [InlineData("No space left on device : '/data/kitti/label.txt.0123456789abcdef.partial'", 28, "'/data/kitti/label.txt'")]
    [InlineData("No space left on device", 28, "'kitti'")]
    [InlineData(
        "There is not enough space on the disk. : 'D:\\out\\p.html.0123456789abcdef.partial'",
        unchecked((int)0x80070070),
        "'D:\\out\\p.html'"
    )]
    public void Full_disk_is_reported_with_the_path_and_advice(string message, int code, string place) =>
        Assert.Equal(
            $"The disk is full: {place} cannot be written. Free some space, or write to another disk, and run the command again.",
            FileFault.TextOf(new IOException(message, code), "kitti")
        );

    [Fact]
    public void Full_disk_without_a_path_is_still_reported() =>
        Assert.StartsWith(
            "The disk is full. Free some space",
            FileFault.TextOf(new IOException("No space left on device", 28), output: null),
            StringComparison.Ordinal
        );

    [Fact]
    public void File_without_read_permission_is_reported_as_such() =>
        Assert.Equal(
            $"Permission denied: '{_folder.PathOf("file")}'. Change its permissions, or name another path.",
            FileFault.TextOf(
                new UnauthorizedAccessException($"Access to the path '{_folder.PathOf("file")}' is denied.") { Source = Runtime },
                output: null
            )
        );

    [Fact]
    public void Folder_in_place_of_a_file_is_reported_as_such() =>
        Assert.Equal(
            $"'{_folder.PathOf("folder")}' is a folder. Name a file.",
            FileFault.TextOf(new IOException($"Is a directory : '{_folder.PathOf("folder")}'") { Source = Runtime }, output: null)
        );

    [Fact]
    public void Messages_of_the_project_are_left_unchanged() =>
        Assert.Equal("'out' is no drive.", FileFault.TextOf(new FileNotFoundException("'out' is no drive."), "x"));

    private static string? Runtime => typeof(File).Assembly.GetName().Name;

    private string InFolder(string text) =>
        text.Replace("{folder}", _folder.PathOf("folder"), StringComparison.Ordinal)
            .Replace("{file}", _folder.PathOf("file"), StringComparison.Ordinal)
            .Replace("{none}", _folder.PathOf("none"), StringComparison.Ordinal)
            .Replace("{.}", _folder.Path, StringComparison.Ordinal);
}
