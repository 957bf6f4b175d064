using Harvester.TestSupport;

namespace Harvester.Exports.Tests.OpenLabel;

public sealed class OpenLabelCheckTests(SimulatedSession simulated) : CheckTests(simulated, "openlabel")
{
    private const string Labels = "labels/train/0000.json";

    [Theory]
    [InlineData("1\\.0\\.0", "1.0.1", "line 1: schema_version is not 1.0.0.")]
    [InlineData("\"camera_matrix\":\\[[^,]*,0,", "\"camera_matrix\":[0,0,", "line 1: camera_matrix is not the matrix of a camera.")]
    [InlineData("\"parent\":\"world\"", "\"parent\":\"ego\"", "line 1: the coordinate systems are not world and others within it.")]
    [InlineData("^\"0\":", "\"1\":", "line 2: it is not frame 0, which must follow.")]
    [InlineData("^\"0\":", "\"0\"", "line 2: invalid JSON at ")]
    [InlineData("train/0000/00000000.png", "train/0000/00000009.png", "line 2: its image 'images/train/0000/00000009.png' is missing.")]
    [InlineData("\"quaternion\":\\[[^,]*", "\"quaternion\":[2", "line 2: the quaternion of ego_to_world is not of length 1.")]
    [InlineData("\"dst\":\"world\"", "\"dst\":\"ego\"", "line 2: ego_to_world is not a transform to world.")]
    [InlineData("\"frame_end\":6\\}\\],\"contexts\"", "\"frame_end\":5}],\"contexts\"", "line 10: frame_intervals is not [{")]
    public void Damage_of_a_frame_is_found(string pattern, string replacement, string expected) =>
        AssertDamageIsFound(Labels, pattern, replacement, $"{Labels}, {expected}");

    [Theory]
    [InlineData("(\"name\":\"box\",.*?\"val\":\\[)[^,]*", "${1}300", "its bbox does not lie in the image of 200 x 150.")]
    [InlineData("(\"name\":\"cuboid\",.*?\"val\":\\[(?:[^,]*,){3})[^,]*", "${1}2", "the quaternion of its cuboid is not of length 1.")]
    [InlineData("(\"name\":\"line 0\",.*?\"val\":\\[)[^,]*", "${1}300", "a point of a line does not lie in the image of 200 x 150.")]
    [InlineData("MODE_POLY2D_ABSOLUTE", "ABSOLUTE", "a line is closed, or its mode is unknown.")]
    public void Damage_of_an_object_is_found(string pattern, string replacement, string expected)
    {
        Export();
        Damage(Labels, pattern, replacement);
        Assert.Contains(
            Problems(),
            problem =>
                problem.StartsWith($"{Labels}, line ", StringComparison.Ordinal) && problem.EndsWith(expected, StringComparison.Ordinal)
        );
    }

    [Theory]
    [InlineData("^(\"\\d+\":\\{\"name\":.*\n)", "$1$1", " occurs twice.")]
    [InlineData("^(\"\\d+\":\\{\"name\":.*\"frame_start\":)\\d+", "${1}7", ", the frames that have it.")]
    [InlineData("^\"\\d+\":\\{\"name\":", "\"9999\":{\"name\":", "it is not an object of a frame.")]
    public void Damage_of_the_list_of_objects_is_found(string pattern, string replacement, string expected)
    {
        Export();
        Damage(Labels, pattern, replacement);
        Assert.Contains(
            Problems(),
            problem =>
                problem.StartsWith($"{Labels}, line 1", StringComparison.Ordinal) && problem.EndsWith(expected, StringComparison.Ordinal)
        );
    }

    [Fact]
    public void Lost_end_frame_object_and_file_are_found()
    {
        Export();
        Damage(Labels, "^\"6\":.*\n", "");
        AssertFound($"{Labels}: it has 6 frames, but images/train/0000 has 7 images.");
        Damage(Labels, "^\\}\\}\\}\n", "");
        AssertFound($"{Labels}: it is cut off");
        Delete(Labels);
        AssertFound($"{Labels}: it is missing, but its images exist.");
    }
}
