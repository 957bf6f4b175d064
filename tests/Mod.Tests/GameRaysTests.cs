using GTA.Hosting;
using Harvester.Geometry;
using Harvester.Geometry.Visibility;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

public sealed class GameRaysTests
{
    private const double ReachMetres = 100;
    private static readonly Vector3D Start = new(0, 0, 50);

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(8)]
    public void Rays_that_hit_nothing_are_misses(int boolBytes)
    {
        var rays = new GameRays();
        GameHost.Current = new TestGame("nowhere") { BoolBytes = boolBytes };
        for (int degrees = 0; degrees < 150; degrees++)
        {
            var up = new Vector3D(Math.Cos(degrees), Math.Sin(degrees), 1);

            Assert.Null(Cast(rays, up));
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    [InlineData(8)]
    public void Ray_that_reaches_the_ground_is_a_hit(int boolBytes)
    {
        var game = new TestGame("nowhere") { BoolBytes = boolBytes };
        GameHost.Current = game;
        RayHit? hit = Cast(new GameRays(), new Vector3D(0, 0, -1));

        Assert.Equal(new RayHit(50, RayHit.World) { Material = TestGame.Concrete, NormalZ = 1 }, hit);
        Assert.Empty(game.LeakedScriptHandles);
        Assert.Empty(game.Misuses);
    }

    private static RayHit? Cast(GameRays rays, Vector3D direction) =>
        ScriptThread.Run(() => rays.Cast(new Ray(Start, direction), ReachMetres, 0));
}
