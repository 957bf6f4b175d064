using Harvester.Play.Features;
using Harvester.Play.Tests.Plans;

namespace Harvester.Play.Tests.Features;

public sealed class PlayerSkyTests
{
    private readonly TrialWorld _world = new();

    [Fact]
    public void Weather_kept_before_a_moment_is_kept_after_it()
    {
        _world.KeepWeather("rain");
        var sky = new PlayerSky(_world, _world) { Kept = () => "rain" };
        sky.Set("clear", null);
        Assert.Equal("clear", _world.Weather);
        sky.Restore();

        Assert.Equal("rain", _world.Weather);
    }

    [Fact]
    public void Weather_is_released_if_none_was_kept()
    {
        var sky = new PlayerSky(_world, _world);
        sky.Set("rain", null);
        sky.Restore();

        Assert.Null(_world.Weather);
    }

    [Fact]
    public void What_the_game_refused_to_restore_is_restored_later()
    {
        var sky = new PlayerSky(_world, _world);
        sky.Set("rain", null);
        _world.RefusesTime = true;
        Assert.Throws<InvalidOperationException>(sky.Restore);
        Assert.True(sky.IsOn);
        _world.RefusesTime = false;
        sky.Tick();

        Assert.False(sky.IsOn);
        Assert.Null(_world.Weather);
    }
}
