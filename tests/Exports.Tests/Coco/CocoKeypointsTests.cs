using System.Text.Json;
using Harvester.Exports.Validation;

namespace Harvester.Exports.Tests.Coco;

public sealed class CocoKeypointsTests : ExportTests
{
    private const string File = "out/annotations/person_keypoints_train.json";

    public CocoKeypointsTests()
    {
        Session.DeterminePedestrians();
        Session.AddJoints();
        for (int frame = 0; frame < 3; frame++)
        {
            Session.PaintMask(frame, (1, 38, 28, 43, 33), (2, 70, 24, 80, 36));
        }
    }

    [Fact]
    public void Keypoints_are_the_joints_in_the_order_of_coco()
    {
        JsonElement person = Exported()[0];

        double[] numbers = [.. person.GetProperty("keypoints").EnumerateArray().Select(number => number.GetDouble())];
        (double X, double Y, double Flag)[] points = [.. numbers.Chunk(3).Select(point => (point[0], point[1], point[2]))];
        Assert.Equal(17, points.Length);

        // Left and right shoulder, elbow, hip and knee; a metre is 6 pixels. The person's left is at the right.
        Assert.Equal((77.2, 26.52, 2), points[5]);
        Assert.Equal((74.8, 26.52, 2), points[6]);
        Assert.Equal((74.5, 28.2, 1), points[8]);
        Assert.Equal((76.6, 30, 2), points[11]);
        Assert.Equal((76.6, 32.7, 1), points[13]);
        Assert.Equal(17, person.GetProperty("num_keypoints").GetInt32());
        Assert.Equal(120, person.GetProperty("area").GetDouble());
    }

    [Fact]
    public void Face_looks_where_the_shoulders_do()
    {
        // The right shoulder is at the left of the image, so that the person looks at the camera: the left ear is at the right.
        double[] numbers = [.. Exported()[0].GetProperty("keypoints").EnumerateArray().Select(number => number.GetDouble())];
        (double X, double Flag)[] face = [.. numbers.Chunk(3).Take(5).Select(point => (point[0], point[2]))];

        Assert.True(face[2].X < face[1].X, "The right eye is not at the left.");
        Assert.True(face[4].X < face[3].X, "The right ear is not at the left.");

        // The head is at column 76, right of the middle, and what is nearer to the camera is farther from the middle.
        Assert.InRange(face[0].X, 76.9, 77.2);
        Assert.Equal([2, 2, 2], face[..3].Select(point => point.Flag));
    }

    [Fact]
    public void Joints_outside_the_image_are_not_labelled()
    {
        foreach (var person in Enumerable.Range(0, 3).Select(Session.Pedestrian))
        {
            person["joints"]![4]!["visibility"] = "outside";
        }

        JsonElement exported = Exported()[0];

        Assert.Equal([0, 0, 0], exported.GetProperty("keypoints").EnumerateArray().Skip(18).Take(3).Select(number => number.GetDouble()));
        Assert.Equal(16, exported.GetProperty("num_keypoints").GetInt32());
    }

    [Fact]
    public void People_without_joints_have_no_keypoints()
    {
        foreach (var person in Enumerable.Range(0, 3).Select(Session.Pedestrian))
        {
            person.Remove("joints");
            person.Remove("box2dJoints");
        }

        Assert.All(Exported(), person => Assert.Equal(0, person.GetProperty("num_keypoints").GetInt32()));
    }

    [Theory]
    [InlineData("\"num_keypoints\":17", "\"num_keypoints\":16", "num_keypoints is not the number")]
    [InlineData("\"keypoints\":\\[7\\d", "\"keypoints\":[97", "a keypoint does not lie in the image")]
    [InlineData(",2\\],\"num", ",3],\"num", "the flag of a keypoint is not 0, 1 or 2")]
    [InlineData(",2\\],\"num", ",0],\"num", "a keypoint that is not labelled is not at 0, 0")]
    [InlineData("\"category_id\":1", "\"category_id\":2", "its category is not listed")]
    public void Damaged_annotation_is_found(string pattern, string replacement, string expected)
    {
        Exported();
        string path = Folder.PathOf(File);
        string text = System.IO.File.ReadAllText(path);
        string damaged = new System.Text.RegularExpressions.Regex(pattern).Replace(text, replacement, 1);
        Assert.NotEqual(text, damaged);
        System.IO.File.WriteAllText(path, damaged);

        Assert.Contains(
            DatasetValidator.Validate(Folder.PathOf("out")).Problems,
            problem => problem.ToString().Contains(expected, StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Export_is_valid()
    {
        Exported();

        Assert.Empty(DatasetValidator.Validate(Folder.PathOf("out")).Problems);
    }

    private JsonElement[] Exported()
    {
        Folder.Export("coco-keypoints", Session.Open());
        using var coco = JsonDocument.Parse(System.IO.File.ReadAllText(Folder.PathOf(File)));
        return [.. coco.RootElement.GetProperty("annotations").Clone().EnumerateArray()];
    }
}
