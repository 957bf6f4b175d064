using System.Text.Json.Nodes;
using Harvester.Datasets.Validation;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>A good session has no problem; each kind of damage is one, with its line.</summary>
public sealed class SessionValidatorTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Validate_of_a_good_session_finds_nothing()
    {
        SessionValidation validation = SessionValidator.Validate(_session.Open());

        Assert.Empty(validation.Problems);
        Assert.True(validation.IsGood);
        Assert.Equal(3, validation.Frames);
        Assert.Equal(6, validation.Objects);
    }

    [Fact]
    public void Validate_of_an_empty_session_finds_nothing()
    {
        _session.Lines.Clear();
        _session.Info["counters"]!["captured"] = 0;

        Assert.Empty(SessionValidator.Validate(_session.Open()).Problems);
    }

    [Fact]
    public void Validate_of_a_session_cut_off_while_it_was_recorded_takes_its_lines_as_they_are()
    {
        _session.Info.Remove("counters");
        _session.Lines.RemoveAt(2);

        Assert.Empty(SessionValidator.Validate(_session.Open()).Problems);
    }

    [Fact]
    public void Validate_finds_lines_that_are_gone()
    {
        _session.Lines.RemoveAt(1);

        SessionProblem problem = Assert.Single(SessionValidator.Validate(_session.Open()).Problems);

        Assert.Equal("session.json: it counts 3 captured frames, but labels.jsonl has 2 good lines.", problem.ToString());
    }

    [Fact]
    public void Validate_finds_a_malformed_session_file()
    {
        _session.Info.Remove("image");

        Assert.Equal("session.json: image is missing.", Assert.Single(SessionValidator.Validate(_session.Open()).Problems).ToString());
    }

    [Fact]
    public void Validate_finds_a_line_that_is_cut_off()
    {
        string whole = _session.Lines[0].ToJsonString();

        SessionValidation validation = SessionValidator.Validate(_session.OpenWithLabels(whole + "\n" + whole[..200]));

        AssertProblem(validation, 2, "not JSON");
        Assert.Equal(1, validation.Frames);
    }

    [Fact]
    public void Validate_finds_an_empty_line() =>
        AssertProblem(SessionValidator.Validate(_session.OpenWithLabels("\n")), 1, "not JSON");

    [Fact]
    public void Validate_finds_a_missing_field()
    {
        _session.Car(1).Remove("box2dAmodal");

        AssertProblem(2, "objects[0].box2dAmodal is missing");
    }

    [Fact]
    public void Validate_finds_an_unknown_class()
    {
        _session.Car(1)["class"] = "Car";

        AssertProblem(2, "objects[0].class must be one of car, truck");
    }

    [Fact]
    public void Validate_finds_a_missing_image()
    {
        File.Delete(_session.PathOf("frames/00000001.png"));

        AssertProblem(2, "image 'frames/00000001.png' is missing");
    }

    [Fact]
    public void Validate_finds_a_missing_mask()
    {
        File.Delete(_session.PathOf("masks/00000002.png"));

        AssertProblem(3, "mask 'masks/00000002.png' is missing");
    }

    [Fact]
    public void Validate_finds_an_image_of_another_size()
    {
        File.WriteAllBytes(_session.PathOf("frames/00000000.png"), TestImages.Png(81, 60));

        AssertProblem(1, "is 81 x 60, but its label says 80 x 60");
    }

    [Fact]
    public void Validate_finds_a_mask_of_another_size()
    {
        File.WriteAllBytes(_session.PathOf("masks/00000000.png"), TestImages.Png(80, 61, 16, 0));

        AssertProblem(1, "is 80 x 61, but its label says 80 x 60");
    }

    [Fact]
    public void Validate_finds_a_mask_of_8_bits()
    {
        File.WriteAllBytes(_session.PathOf("masks/00000000.png"), TestImages.Png(80, 60, 8, 0));

        AssertProblem(1, "has 8 bits a pixel instead of 16");
    }

    [Fact]
    public void Validate_finds_an_image_that_is_cut_off()
    {
        File.WriteAllBytes(_session.PathOf("frames/00000000.png"), TestImages.Png(80, 60)[..40]);

        AssertProblem(1, "cut off");
    }

    [Fact]
    public void Validate_finds_an_image_that_is_none()
    {
        File.WriteAllText(_session.PathOf("frames/00000000.png"), "not an image");

        AssertProblem(1, "neither a PNG nor a BMP");
    }

    [Theory]
    [InlineData("../frames/00000000.png")]
    [InlineData("frames\\..\\..\\x.png")]
    [InlineData("/etc/passwd")]
    public void Validate_finds_a_path_out_of_the_session(string path)
    {
        _session.Lines[0]["image"] = path;

        AssertProblem(1, "points out of the session");
    }

    [Fact]
    public void Validate_finds_an_image_named_twice()
    {
        _session.Lines[1]["image"] = "frames/00000000.png";

        AssertProblem(2, "belongs to an earlier line");
    }

    [Fact]
    public void Validate_finds_a_camera_of_another_size_than_the_session()
    {
        _session.Info["image"]!["width"] = 800;

        Assert.Contains(SessionValidator.Validate(_session.Open()).Problems, problem => problem.Message.Contains("800 x 60", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("verticalFovDegrees", 180, "camera: verticalFovDegrees")]
    [InlineData("nearClip", 0, "camera: nearClip")]
    [InlineData("windowAspect", -1, "camera: windowAspect")]
    [InlineData("fy", 31, "camera: fx and fy are 30 and 31, but the other fields make them 30 and 30.")]
    public void Validate_finds_a_camera_that_cannot_be(string field, double value, string message)
    {
        _session.Lines[1]["camera"]![field] = value;

        AssertProblem(2, message);
    }

    [Theory]
    [InlineData("[-1, 27, 43, 33]", "does not lie in the image")]
    [InlineData("[37, 27, 81, 33]", "does not lie in the image")]
    [InlineData("[37, 27, 43, 34]", "does not lie within box2dAmodal")]
    [InlineData("[43, 27, 37, 33]", "has no area")]
    [InlineData("[37, 27, 43, 27]", "has no area")]
    public void Validate_finds_a_box_that_cannot_be(string box, string message)
    {
        _session.Car(2)["box2d"] = JsonNode.Parse(box);

        Assert.Contains(
            SessionValidator.Validate(_session.Open()).Problems,
            problem => problem.Line == 3 && problem.Message.Contains(message, StringComparison.Ordinal));
    }

    [Fact]
    public void Validate_finds_visible_pixels_outside_the_box()
    {
        _session.Car(0)["box2dVisible"] = JsonNode.Parse("[35, 27, 43, 33]");

        AssertProblem(1, "box2dVisible [35, 27, 43, 33] does not lie within box2d");
    }

    [Theory]
    [InlineData("truncatedFraction", -0.01)]
    [InlineData("truncatedFraction", 1.01)]
    [InlineData("occludedFraction", -0.01)]
    [InlineData("occludedFraction", 1.01)]
    public void Validate_finds_a_fraction_out_of_range(string field, double value)
    {
        _session.Car(0)[field] = value;

        AssertProblem(1, $"{field} is");
    }

    [Fact]
    public void Validate_finds_a_distance_that_contradicts_the_cuboid()
    {
        _session.Car(0)["distanceMetres"] = 12;

        AssertProblem(1, "distanceMetres is 12, but box3d.centre is 11 m from the camera");
    }

    [Fact]
    public void Validate_finds_an_id_that_changes_its_model()
    {
        _session.Car(2)["model"] = "dilettante";

        AssertProblem(3, "object 1 is car 'dilettante', but was car 'blista' in an earlier frame");
    }

    [Fact]
    public void Validate_finds_an_id_that_changes_its_class()
    {
        _session.Car(2)["class"] = "truck";

        AssertProblem(3, "object 1 is truck 'blista', but was car 'blista'");
    }

    [Fact]
    public void Validate_finds_an_id_twice_in_a_frame()
    {
        _session.Lines[0]["objects"]![1]!["id"] = 1;

        Assert.Contains(
            SessionValidator.Validate(_session.Open()).Problems,
            problem => problem.Line == 1 && problem.Message.Contains("two objects have the id 1", StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("null", """{"face":0,"mutcd":null,"facesCamera":true,"facingAngleDegrees":10,"provenance":"derived","light":null}""", "parent and space go together")]
    [InlineData("77", "null", "parent and space go together")]
    [InlineData("0", """{"face":0,"mutcd":null,"facesCamera":true,"facingAngleDegrees":10,"provenance":"derived","light":null}""", "parent is 0")]
    [InlineData("77", """{"face":0,"mutcd":null,"facesCamera":true,"facingAngleDegrees":181,"provenance":"derived","light":null}""", "facingAngleDegrees is 181")]
    [InlineData("77", """{"face":0,"mutcd":null,"facesCamera":true,"facingAngleDegrees":10,"provenance":"guessed","light":null}""", "space.provenance must be one of estimated, derived, measured")]
    [InlineData(
        "77",
        """{"face":0,"mutcd":null,"facesCamera":true,"facingAngleDegrees":10,"provenance":"derived","light":{"state":"red","method":"set","litFraction":null}}""",
        "light must be given for a trafficLight")]
    public void Validate_finds_a_part_that_cannot_be(string parent, string space, string message)
    {
        _session.Car(1)["parent"] = JsonNode.Parse(parent);
        _session.Car(1)["space"] = JsonNode.Parse(space);

        AssertProblem(2, message);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(65536)]
    public void Validate_finds_an_id_that_no_mask_can_hold(int id)
    {
        _session.Car(0)["id"] = id;

        AssertProblem(1, "ids are 1 to 65535");
    }

    [Theory]
    [InlineData(0)]
    [InlineData(-7)]
    public void Validate_finds_frame_numbers_that_do_not_rise(int frame)
    {
        _session.Lines[1]["frame"] = frame;

        AssertProblem(2, $"frame is {frame}, but the numbers must rise");
    }

    [Fact]
    public void Validate_collects_all_problems_in_the_order_of_lines()
    {
        _session.Car(0)["truncatedFraction"] = 2;
        _session.Lines[1].Remove("ego");
        File.Delete(_session.PathOf("frames/00000002.png"));

        SessionValidation validation = SessionValidator.Validate(_session.Open());

        Assert.Equal([1, 2, 3], validation.Problems.Where(problem => problem.Line is not null).Select(problem => problem.Line!.Value));
    }

    private void AssertProblem(int line, string message) => AssertProblem(SessionValidator.Validate(_session.Open()), line, message);

    private static void AssertProblem(SessionValidation validation, int line, string message)
    {
        // A line that cannot be read also makes the count of session.json wrong; that is a problem of another file.
        SessionProblem problem = Assert.Single(validation.Problems, problem => problem.Line is not null);
        Assert.Equal(line, problem.Line);
        Assert.Contains(message, problem.Message, StringComparison.Ordinal);
    }
}
