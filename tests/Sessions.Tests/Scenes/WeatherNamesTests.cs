using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Tests.Scenes;

public sealed class WeatherNamesTests
{
    [Theory]
    [InlineData("EXTRASUNNY", "extrasunny")]
    [InlineData("RAIN", "rain")]
    [InlineData("someModsWeather", "unknown")]
    public void Of_a_hash_is_the_name_of_the_weather(string name, string expected) =>
        Assert.Equal(expected, WeatherNames.Of(ModelHash.Of(name)));

    [Fact]
    public void All_15_weathers_of_the_game_are_known_by_hash()
    {
        Assert.Equal(15, WeatherNames.All.Distinct().Count());
        Assert.All(WeatherNames.All, name => Assert.Equal(name, WeatherNames.Of(ModelHash.Of(name))));
    }
}
