using System.Text.Json.Nodes;
using Harvester.Datasets.Validation;
using Harvester.Sessions.Reading;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>A valid session has no problem; damage of the session as a whole is reported with its line.</summary>
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
    public void Undetermined_labels_and_regions_are_counted()
    {
        _session.Lines[0]["ignoreRegions"] = JsonNode.Parse(
            """
            [
              { "reason": "undetermined", "class": "car", "box2d": [60, 20, 70, 25], "distanceMetres": 140 },
              { "reason": "beyondRange", "class": "car", "box2d": [60, 20, 70, 25], "distanceMetres": 157 }
            ]
            """
        );

        SessionValidation validation = SessionValidator.Validate(_session.Open());

        // The pedestrian of each frame has the method none.
        Assert.Equal((3, 1), (validation.Undetermined, validation.UndeterminedRegions));
        Assert.True(validation.IsGood);
    }

    [Fact]
    public void Validate_of_an_empty_session_finds_nothing()
    {
        _session.Lines.Clear();
        _session.Info["counters"]!["captured"] = 0;

        Assert.Empty(SessionValidator.Validate(_session.Open()).Problems);
    }

    [Fact]
    public void Validate_of_an_interrupted_session_accepts_complete_lines()
    {
        _session.Info.Remove("counters");
        _session.Lines.RemoveAt(2);

        Assert.Empty(SessionValidator.Validate(_session.Open()).Problems);
    }

    [Fact]
    public void Validate_finds_missing_lines()
    {
        _session.Lines.RemoveAt(1);

        SessionProblem problem = Assert.Single(SessionValidator.Validate(_session.Open()).Problems);

        Assert.Equal("session.json: it counts 3 captured frames, but labels.jsonl has 2 valid lines.", problem.ToString());
    }

    [Fact]
    public void Validate_finds_a_malformed_session_file()
    {
        _session.Info.Remove("image");

        Assert.Equal("session.json: image is missing.", Assert.Single(SessionValidator.Validate(_session.Open()).Problems).ToString());
    }

    [Fact]
    public void Validate_finds_a_truncated_line()
    {
        string whole = _session.Lines[0].ToJsonString();

        SessionValidation validation = SessionValidator.Validate(_session.OpenWithLabels(whole + "\n" + whole[..200] + "\n"));

        validation.AssertProblem(2, "invalid JSON at byte");
        Assert.Equal(1, validation.Frames);
    }

    [Fact]
    public void Validate_ignores_an_unfinished_last_line()
    {
        string lines = string.Concat(_session.Lines.Select(line => line.ToJsonString() + "\n"));

        SessionValidation validation = SessionValidator.Validate(_session.OpenWithLabels(lines + lines[..200]));

        Assert.Empty(validation.Problems);
        Assert.Equal(3, validation.Frames);
    }

    [Fact]
    public void Validate_finds_an_empty_line() =>
        SessionValidator.Validate(_session.OpenWithLabels("\n")).AssertProblem(1, "invalid JSON at byte");

    [Fact]
    public void Validate_finds_a_missing_field()
    {
        _session.Car(1).Remove("box2dAmodal");

        _session.AssertProblem(2, "objects[0].box2dAmodal is missing");
    }

    [Fact]
    public void Validate_finds_an_unknown_class()
    {
        _session.Car(1)["class"] = "Car";

        _session.AssertProblem(2, "objects[0].class must be one of car, truck");
    }

    [Fact]
    public void Validate_collects_all_problems_in_the_order_of_lines()
    {
        _session.Car(0)["distanceMetres"] = 12;
        _session.Lines[1].Remove("ego");
        File.Delete(_session.PathOf("frames/00000002.png"));

        SessionValidation validation = SessionValidator.Validate(_session.Open());

        Assert.Equal([1, 2, 3], validation.Problems.Where(problem => problem.Line is not null).Select(problem => problem.Line!.Value));
    }
}
