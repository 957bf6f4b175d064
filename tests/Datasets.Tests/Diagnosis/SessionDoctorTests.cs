using System.Text.Json.Nodes;
using Harvester.Datasets.Diagnosis;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Diagnosis;

public sealed class SessionDoctorTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Fact]
    public void Good_session_has_no_finding() => Assert.Empty(Examine());

    [Theory]
    [InlineData("black", "exclusive full screen", "windowed borderless")]
    [InlineData("neverStill", "kept moving", "Freeze = Auto")]
    public void Session_that_lost_most_frames_is_explained(string reason, string cause, string advice)
    {
        _session.Info["options"] = JsonNode.Parse("""{ "freezeBy": "paused" }""");
        _session.Info["counters"] = JsonNode.Parse(
            $$"""{ "captured": 3, "discarded": 52, "discards": { "{{reason}}": 50, "objectMoved": 2 } }"""
        );

        Finding finding = Assert.Single(Examine());
        Assert.Contains(cause, finding.Cause, StringComparison.Ordinal);
        Assert.Contains(advice, finding.Advice, StringComparison.Ordinal);
        Assert.Equal($"session.json: 3 captured, discarded: 50 {reason}, 2 objectMoved", finding.Evidence!.ToString());
    }

    [Theory]
    [InlineData(
        "The camera model is off by 3.1 px, more than the 1.0 px allowed: calibrate the camera first.",
        "does not fit the camera model"
    )]
    [InlineData("The sky fell.", "ended with an error")]
    public void Session_with_a_fault_is_explained(string fault, string cause)
    {
        _session.Info["state"] = "faulted";
        _session.Info["fault"] = fault;

        Assert.Contains(cause, Assert.Single(Examine()).Cause, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("kept", 0)]
    [InlineData("clipped", 1)]
    [InlineData("changed", 1)]
    public void Session_with_other_colours_than_the_game_is_explained(string state, int findings)
    {
        _session.Info["start"] = JsonNode.Parse($$"""{ "colours": { "state": "{{state}}", "grey192": 255, "grey128": 205 } }""");

        IReadOnlyList<Finding> found = Examine();
        Assert.Equal(findings, found.Count);
        Assert.All(found, finding => Assert.Contains("Auto HDR", finding.Cause, StringComparison.Ordinal));
    }

    [Fact]
    public void Interrupted_session_is_named()
    {
        _session.Info["state"] = "recording";
        _session.Info.Remove("counters");

        Assert.Contains("cut off", Assert.Single(Examine()).Cause, StringComparison.Ordinal);
    }

    private IReadOnlyList<Finding> Examine()
    {
        _session.Open();
        return Doctor.Examine(_session.Folder).Findings;
    }
}
