using Harvester.Sessions.Scenes;
using Harvester.Simulation.Game;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Settings;

namespace Harvester.Simulation.Tests.Rendering;

public class WeatherTests
{
    /// <summary>Minimum mean difference of the pictures of two weathers, of 255.</summary>
    private const double Visible = 0.5;

    [Fact]
    public void LightingOf_each_name_gives_a_different_picture()
    {
        List<(string Name, byte[] Colour)> pictures = [.. WeatherNames.All.Select(name => (name, PictureOf(name)))];

        // The names of the game's fifteen weathers.
        Assert.Equal(15, pictures.Count);
        for (int i = 0; i < pictures.Count; i++)
        {
            for (int j = 0; j < i; j++)
            {
                double difference = pictures[i].Colour.Zip(pictures[j].Colour, (a, b) => Math.Abs(a - b)).Average();
                Assert.True(difference > Visible, $"{pictures[i].Name} looks like {pictures[j].Name}: they differ by {difference:F2}.");
            }
        }
    }

    [Fact]
    public void Sky_of_dusk_is_redder_than_at_noon_and_lighter_than_at_night()
    {
        // On the first of May the sun sets at 18:43 by the sun's own time.
        Rgb noon = HorizonAt(12);
        Rgb dusk = HorizonAt(18.75);
        Rgb night = HorizonAt(23);

        Assert.True(dusk.Red - dusk.Blue > noon.Red - noon.Blue + 20, $"The horizon is {dusk} at dusk and {noon} at noon.");
        Assert.True(dusk.Red > night.Red + 40, $"The horizon is {dusk} at dusk and {night} at night.");
        Assert.NotEqual(default, Weather.LightingOf("clear", 121, TimeSpan.FromHours(18.75)).GlowColour);
    }

    [Fact]
    public void LightingOf_unknown_name_is_refused_with_the_names()
    {
        ArgumentException error = Assert.Throws<ArgumentException>(() => new SimulatedGame(new SimulationOptions { Weather = "sunny" }));

        Assert.Contains("'sunny'", error.Message, StringComparison.Ordinal);
        Assert.All(WeatherNames.All, name => Assert.Contains(name, error.Message, StringComparison.Ordinal));
    }

    private static Rgb HorizonAt(double hour) => Weather.LightingOf("clear", 121, TimeSpan.FromHours(hour)).HorizonColour;

    private static byte[] PictureOf(string weather)
    {
        RenderScene scene = TestScene.Seeded(4);
        scene.Lighting = Weather.LightingOf(weather, 121, TimeSpan.FromHours(12));
        return TestScene.Render(scene, TestScene.Camera).Colour;
    }
}
