using System.Text.Json;
using System.Windows.Forms;
using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod.Tests;

/// <summary>The joints that the mod reads from the bones of peds.</summary>
public sealed class PedJointTests
{
    private const int Ticks = 120;

    [Fact]
    public void Label_has_the_bones_of_a_ped()
    {
        using var driver = new ScriptDriver();
        StreetWithoutPeds(driver.Game);
        Skeleton skeleton = AddPed(driver.Game, 12);

        JsonElement person = Harvested(driver)[0];

        JsonElement[] joints = [.. person.GetProperty("joints").EnumerateArray()];
        Assert.Equal(JointNames.All, joints.Select(joint => joint.GetProperty("joint").GetString()));

        // The crown has no bone: it is as far beyond the head as that is from the neck.
        Vector3D[] expected = [.. skeleton.Joints];
        expected[0] = (expected[1] * 2) - expected[2];
        const double rounding = 1e-3;
        Assert.All(joints.Zip(expected), pair => Assert.InRange((PositionOf(pair.First) - pair.Second).Length, 0, rounding));
    }

    [Theory]
    [InlineData(95, true)]
    [InlineData(105, false)]
    public void Only_peds_within_100_m_have_joints(double north, bool hasJoints)
    {
        using var driver = new ScriptDriver("[Harvest]\nWidth = 1600\nHeight = 1200\n");
        StreetWithoutPeds(driver.Game);
        AddPed(driver.Game, north);

        Assert.Equal(hasJoints, Harvested(driver)[0].TryGetProperty("joints", out _));
    }

    [Fact]
    public void Ped_without_the_bones_of_people_has_no_joints()
    {
        using var driver = new ScriptDriver();
        StreetWithoutPeds(driver.Game);
        AddPed(driver.Game, 12);
        driver.Game.Entities.Values.Single(entity => entity.Skeleton is not null).Skeleton = null;

        Assert.False(Harvested(driver)[0].TryGetProperty("joints", out _));
        Assert.DoesNotContain(Hash.GET_PED_BONE_COORDS, driver.Game.Calls);
    }

    [Fact]
    public void No_bones_are_read_of_a_ped_behind_the_camera()
    {
        using var driver = new ScriptDriver();
        StreetWithoutPeds(driver.Game);
        AddPed(driver.Game, -12);

        Assert.Empty(Harvested(driver));

        Assert.DoesNotContain(Hash.GET_PED_BONE_COORDS, driver.Game.Calls);
    }

    [Fact]
    public void Bones_of_a_model_are_looked_up_once()
    {
        const int bones = 21;
        using var driver = new ScriptDriver();
        StreetWithoutPeds(driver.Game);
        AddPed(driver.Game, 12);
        AddPed(driver.Game, 14);

        Harvested(driver);

        Assert.Equal(bones, driver.Game.Calls.Count(call => call == Hash.GET_PED_BONE_INDEX));
    }

    private static void StreetWithoutPeds(TestGame game)
    {
        HarvestTests.Street(game);
        foreach (int ped in game.Entities.Where(entity => entity.Value.Pool == PoolKind.Peds).Select(entity => entity.Key).ToArray())
        {
            game.Entities.Remove(ped);
        }
    }

    /// <summary>Adds a ped ahead of the camera whose joints are scattered, so that none can be taken for another.</summary>
    private static Skeleton AddPed(TestGame game, double ahead)
    {
        GameEntity ego = game.Entities[game.PlayersVehicle];

        // Beside the car that is parked ahead.
        Vector3D place = ego.Pose.ToWorld(new Vector3D(ahead / 8, ahead, 1));
        var skeleton = new Skeleton(
            Enumerable
                .Range(0, Skeleton.Count)
                .Select(joint => place + new Vector3D(0.01 * joint, 0.02 * ((joint * 7) % 22), 0.9 - (0.08 * joint)))
        );
        game.Add(
            new GameEntity
            {
                Pool = PoolKind.Peds,
                Name = "a_m_y_hipster_01",
                Pose = new Pose(place, Axes.Identity),
                ModelMin = new(-0.4, -0.4, -1),
                ModelMax = new(0.4, 0.4, 0.9),
                Skeleton = skeleton,
            }
        );
        return skeleton;
    }

    private static IReadOnlyList<JsonElement> Harvested(ScriptDriver driver)
    {
        driver.Press(Keys.J);
        driver.Tick(Ticks);
        driver.Press(Keys.J);
        driver.WaitForDisk();
        string[] lines = File.ReadAllLines(Path.Combine(Assert.Single(Directory.GetDirectories(driver.Output)), "labels.jsonl"));
        return
        [
            .. lines
                .SelectMany(line => JsonDocument.Parse(line).RootElement.GetProperty("objects").EnumerateArray())
                .Where(item => item.GetProperty("class").GetString() == "pedestrian"),
        ];
    }

    private static Vector3D PositionOf(JsonElement joint)
    {
        double[] position = [.. joint.GetProperty("position").EnumerateArray().Select(number => number.GetDouble())];
        return new Vector3D(position[0], position[1], position[2]);
    }
}
