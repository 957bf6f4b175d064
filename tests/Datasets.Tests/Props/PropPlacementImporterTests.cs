using Harvester.Datasets.Props;
using Harvester.Geometry;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Scenes;
using Harvester.TestSupport;

namespace Harvester.Datasets.Tests.Props;

public sealed class PropPlacementImporterTests : IDisposable
{
    private readonly string _file = Path.GetTempFileName();

    public void Dispose() => File.Delete(_file);

    [Fact]
    public void Import_list_gives_every_prop_with_its_place()
    {
        File.WriteAllText(
            _file,
            """
            [{"Name": "prop_traffic_01d", "Position": {"X": -99.25, "Y": 1.5, "Z": 33}, "Rotation": {"X": 0.0, "Y": -0.0, "Z": 160}}]
            """
        );

        PropPlacement prop = Assert.Single(PropPlacementImporter.Import(_file));

        Assert.Equal("prop_traffic_01d", prop.Name);
        Assert.Equal(new Vector3D(-99.25, 1.5, 33), prop.Position);
        Assert.Equal(160, prop.Rotation.YawDegrees);
    }

    [Theory]
    [InlineData("""[{"Name": "a", "Position": {"X": 1, "Y": 1}, "Rotation": {"X": 0, "Y": 0, "Z": 0}}]""", "prop 0: Position.Z is missing")]
    [InlineData(
        """[{"Name": "a", "Position": {"X": 1e999, "Y": 1, "Z": 1}, "Rotation": {"X": 0, "Y": 0, "Z": 0}}]""",
        "Position.X must be a finite number"
    )]
    [InlineData("[{\"Name\": \"a\",\n", "line 2")]
    [InlineData("{}", "a list of props")]
    public void Import_of_an_invalid_prop_list_names_the_position(string text, string expected)
    {
        File.WriteAllText(_file, text);

        var error = Assert.Throws<DatasetFormatException>(() => PropPlacementImporter.Import(_file));

        Assert.Contains(expected, error.Message, StringComparison.Ordinal);
    }

    [RealWorldFact("worldTrafficLights.json")]
    public void Import_traffic_lights_of_the_game_gives_all() =>
        Assert.Equal(1_058, PropPlacementImporter.Import(RealWorldFactAttribute.PathOf("worldTrafficLights.json")!).Count);

    [RealWorldFact("worldStreetLights.json")]
    public void Import_street_lights_of_the_game_gives_all() =>
        Assert.Equal(5_896, PropPlacementImporter.Import(RealWorldFactAttribute.PathOf("worldStreetLights.json")!).Count);
}
