using System.Text.Json.Nodes;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Validation;

/// <summary>Parts of objects that cannot be.</summary>
public sealed class SpaceCheckTests : IDisposable
{
    private readonly TestSession _session = new();

    public void Dispose() => _session.Dispose();

    [Theory]
    [InlineData(
        "null",
        """{"face":0,"mutcd":null,"facesCamera":true,"facingAngleDegrees":10,"provenance":"derived","light":null}""",
        "parent and space must be given together"
    )]
    [InlineData("77", "null", "parent and space must be given together")]
    [InlineData(
        "0",
        """{"face":0,"mutcd":null,"facesCamera":true,"facingAngleDegrees":10,"provenance":"derived","light":null}""",
        "parent is 0"
    )]
    [InlineData(
        "77",
        """{"face":0,"mutcd":null,"facesCamera":true,"facingAngleDegrees":181,"provenance":"derived","light":null}""",
        "facingAngleDegrees is 181"
    )]
    [InlineData(
        "77",
        """{"face":0,"mutcd":null,"facesCamera":true,"facingAngleDegrees":10,"provenance":"guessed","light":null}""",
        "space.provenance must be one of estimated, derived, measured"
    )]
    [InlineData(
        "77",
        """{"face":0,"mutcd":null,"facesCamera":true,"facingAngleDegrees":10"""
            + ""","provenance":"derived","light":{"state":"red","method":"set","litFraction":null}}""",
        "light must be given for a trafficLight"
    )]
    public void Validate_finds_an_impossible_part(string parent, string space, string message)
    {
        _session.Car(1)["parent"] = JsonNode.Parse(parent);
        _session.Car(1)["space"] = JsonNode.Parse(space);

        _session.AssertProblem(2, message);
    }
}
