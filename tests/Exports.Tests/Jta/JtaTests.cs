using System.Text.Json;
using Harvester.Exports.Validation;

namespace Harvester.Exports.Tests.Jta;

public sealed class JtaTests : ExportTests
{
    private const string File = "out/annotations/train/seq_0.json";

    public JtaTests()
    {
        Session.DeterminePedestrians();
        Session.AddJoints();
    }

    [Fact]
    public void Rows_are_joints_in_the_columns_of_jta()
    {
        Export();

        using var document = JsonDocument.Parse(System.IO.File.ReadAllText(Folder.PathOf(File)));
        double[][] rows =
        [
            .. document.RootElement.EnumerateArray().Select(row => row.EnumerateArray().Select(value => value.GetDouble()).ToArray()),
        ];
        Assert.Equal(3 * 22, rows.Length);

        // Frame, person, joint, pixel, and position right, down and forward of the camera; neither, self-occluded, occluded.
        Assert.Equal([1, 2, 0, 76, 24.3, 6, -0.95, 5, 0, 0], rows[0]);
        Assert.Equal([2, 2, 5, 74.5, 28.2, 5.75, -0.3, 5, 0, 1], rows[22 + 5]);
        Assert.Equal([3, 2, 20, 76.6, 32.7, 6.1, 0.45, 5, 1, 0], rows[44 + 20]);
    }

    [Fact]
    public void Frames_are_counted_from_1_and_the_camera_is_written()
    {
        Export();

        Assert.True(System.IO.File.Exists(Folder.PathOf("out/frames/train/seq_0/1.png")));
        Assert.True(System.IO.File.Exists(Folder.PathOf("out/frames/train/seq_0/3.png")));
        Assert.Equal(
            """{"fx":30,"fy":30,"cx":40,"cy":30,"width":80,"height":60}""",
            System.IO.File.ReadAllText(Folder.PathOf("out/cameras/train/seq_0.json")).TrimEnd()
        );
        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    [Theory]
    [InlineData("[1,2,0,76,", "[1,2,0,79,", "a position does not project to its pixel")]
    [InlineData("[1,2,0,", "[9,2,0,", "frame 9 has no image")]
    [InlineData("[1,2,0,", "[1,2,22,", "the joint is 22")]
    [InlineData("[1,2,0,", "[1,0,0,", "the person's number is 0")]
    [InlineData("5,0,0]", "5,0,2]", "a flag is not 0 or 1")]
    [InlineData("[1,2,0,", "[1,2,", "10 numbers")]
    public void Damaged_row_is_found(string good, string bad, string expected)
    {
        Export();
        string path = Folder.PathOf(File);
        string text = System.IO.File.ReadAllText(path);
        int at = text.IndexOf(good, StringComparison.Ordinal);
        System.IO.File.WriteAllText(path, text[..at] + bad + text[(at + good.Length)..]);

        Assert.Contains(
            DatasetValidator.Validate(Folder.PathOf("out")).Problems,
            problem => problem.ToString().Contains(expected, StringComparison.Ordinal)
        );
    }

    private void Export() => Folder.Export("jta", Session.Open());
}
