using System.Xml.Linq;
using Harvester.Runs.Scenarios;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenarios;

namespace Harvester.Runs.Tests.Scenarios;

public class OpenScenarioTests
{
    /// <summary>The scenarios of the library that can be written, with the values of a seed.</summary>
    private static Scenario[] Written =>
        [
            .. Directory
                .GetFiles("scenarios", "*.json")
                .Order(StringComparer.Ordinal)
                .Select(file => ScenarioParser.Read(File.ReadAllText(file)).Template!.Drawn(5))
                .Where(scenario => OpenScenarioWriter.Problems(scenario).Count == 0),
        ];

    [Fact]
    public void What_is_written_is_read_as_the_same_scenario()
    {
        Assert.True(Written.Length >= 5);
        Assert.All(
            Written,
            scenario =>
            {
                string text = OpenScenarioWriter.Of(scenario, roads: null);

                Scenario read = ScenarioParser.Read(OpenScenarioReader.Read(text, "other")).Template!.Middle;

                Assert.Equal((scenario.Name, scenario.Kind, scenario.Description), (read.Name, read.Kind, read.Description));
                Assert.Equal(
                    scenario.Actors.Select(actor => (actor.Id, actor.Type, actor.Model)),
                    read.Actors.Select(actor => (actor.Id, actor.Type, actor.Model))
                );
                Assert.Equal(text, OpenScenarioWriter.Of(read, roads: null));
            }
        );
    }

    [Theory]
    [InlineData("RelativeLanePosition", "LanePosition", "a position must be a RelativeLanePosition of 'Ego'.")]
    [InlineData("RelativeDistanceCondition", "ReachPositionCondition", "ReachPositionCondition is not supported")]
    [InlineData("SimulationTimeCondition", "TimeOfDayCondition", "TimeOfDayCondition is not supported")]
    [InlineData("RelativeTargetLane", "AbsoluteTargetLane", "the target must be one lane beside")]
    [InlineData("AbsoluteTargetSpeed", "RelativeTargetSpeed", "SpeedActionTarget must have AbsoluteTargetSpeed.")]
    public void What_has_no_counterpart_is_named_with_its_line(string known, string other, string problem)
    {
        string text = Written
            .Select(scenario => OpenScenarioWriter.Of(scenario, roads: null))
            .First(text => text.Contains($"<{known}", StringComparison.Ordinal));
        string changed = text.Replace($"<{known}", $"<{other}", StringComparison.Ordinal)
            .Replace($"</{known}", $"</{other}", StringComparison.Ordinal);

        string message = Assert.Throws<DatasetFormatException>(() => OpenScenarioReader.Read(changed, "other")).Message;

        Assert.StartsWith("line ", message, StringComparison.Ordinal);
        Assert.Contains(problem, message, StringComparison.Ordinal);
    }

    [Fact]
    public void Parameters_are_refused_by_name()
    {
        string text = OpenScenarioWriter.Of(Written[0], roads: null);
        XElement root = XElement.Parse(text);
        root.Descendants("AbsoluteTargetSpeed").First().SetAttributeValue("value", "$speed");

        string message = Assert.Throws<DatasetFormatException>(() => OpenScenarioReader.Read(root.ToString(), "other")).Message;

        Assert.Contains("value must be a finite number; parameters are not read.", message, StringComparison.Ordinal);
    }
}
