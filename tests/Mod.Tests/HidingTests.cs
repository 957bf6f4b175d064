using System.Windows.Forms;
using GTA.Hosting;
using GTA.Native;
using Harvester.Geometry;
using Harvester.Mod.Tests.Games;

namespace Harvester.Mod.Tests;

/// <summary>What the mod hides for coded masks is shown again, whatever ends the harvest.</summary>
public sealed class HidingTests
{
    private const string Ini = "[Harvest]\nMasks = Coded\nFreeze = Paused\n";

    /// <summary>More than the photographs of a frame take.</summary>
    private const int TicksOfAFrame = 80;

    public static TheoryData<Hash> Natives => [.. OwnNatives];

    /// <summary>The natives that only a harvest with coded masks calls.</summary>
    internal static IReadOnlyList<Hash> OwnNatives { get; } =
    [Hash.IS_ENTITY_VISIBLE, Hash.SET_ENTITY_VISIBLE, Hash.GET_VEHICLE_TRAILER_VEHICLE, Hash.GET_ENTITY_ATTACHED_TO, Hash.DRAW_POLY];

    [Fact]
    [Trait("Category", "Heavy")]
    public void Everything_is_shown_after_an_abort_at_any_tick()
    {
        int hidden = 0;
        for (int ticks = 0; ticks < TicksOfAFrame; ticks += 4)
        {
            using var driver = Harvesting();
            for (int tick = 0; tick < ticks; tick++)
            {
                driver.WaitForDisk();
                driver.Tick();
            }

            hidden += IsAnyHidden(driver) ? 1 : 0;
            driver.Script.RaiseAborted();
            driver.WaitForDisk();

            Assert.False(IsAnyHidden(driver), $"after {ticks} ticks");
            Assert.False(File.Exists(List(driver)), $"after {ticks} ticks");
        }

        Assert.True(hidden > 3, "The harvest hid nothing, so that the test shows nothing.");
    }

    [Fact]
    public void List_is_on_disk_before_anything_is_hidden()
    {
        using var driver = Harvesting();
        bool wasListed = true;
        driver.Game.Fault = native =>
        {
            wasListed &= native != Hash.SET_ENTITY_VISIBLE || File.Exists(List(driver));
            return null;
        };
        driver.Until(() => IsAnyHidden(driver));

        Assert.True(wasListed);
    }

    [Fact]
    public void Next_start_shows_what_a_crashed_script_left_hidden()
    {
        using var driver = Harvesting();
        driver.Until(() => IsAnyHidden(driver));
        string list = File.ReadAllText(List(driver));
        int[] left = [.. driver.Game.Entities.Where(entity => entity.Value.IsHidden).Select(entity => entity.Key)];
        driver.Reload();
        driver.WaitForDisk();

        // As if the script had been torn out of the game in the middle of a tick.
        Array.ForEach(left, entity => driver.Game.Entities[entity].IsHidden = true);
        File.WriteAllText(List(driver), list);
        driver.Reload();
        driver.Until(() => !IsAnyHidden(driver));
        driver.WaitForDisk();

        Assert.False(File.Exists(List(driver)));
        Assert.Contains(driver.Game.Notifications, message => message.Contains("are shown again", StringComparison.Ordinal));
    }

    [Fact]
    public void List_of_another_process_shows_nothing()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        int entity = driver.Game.Entities.Keys.First(handle => handle != TestGame.Player);
        driver.Game.Entities[entity].IsHidden = true;
        File.WriteAllText(List(driver), $"1 20200101-000000\n{entity}\n");
        driver.Tick();
        driver.WaitForDisk();
        driver.Tick();

        Assert.True(driver.Game.Entities[entity].IsHidden);
    }

    [Fact]
    public void Entity_hidden_by_another_mod_stays_hidden()
    {
        using var driver = Harvesting();
        int others = driver.Game.Entities.First(entity => entity.Key != TestGame.Player && entity.Key != driver.Game.PlayersVehicle).Key;
        driver.Game.Entities[others].IsHidden = true;
        driver.Tick(TicksOfAFrame);
        driver.Press(Keys.J);
        driver.WaitForDisk();

        Assert.True(driver.Game.Entities[others].IsHidden);
        Assert.Single(driver.Game.Entities.Values, entity => entity.IsHidden);
    }

    [Fact]
    public void Masks_come_from_rays_if_visibility_does_not_change()
    {
        using var driver = new ScriptDriver(Ini);
        driver.Screen.ShowsHiding = false;
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Until(() =>
            Directory.Exists(driver.Output)
            && Directory
                .GetFiles(driver.Output, "labels.jsonl", SearchOption.AllDirectories)
                .Any(file => File.ReadAllLines(file).Length > 3)
        );
        driver.Press(Keys.J);
        driver.WaitForDisk();

        Assert.Contains(
            driver.Game.Notifications,
            message => message.Contains("Masks come from rays: hidden objects still show", StringComparison.Ordinal)
        );
        Assert.DoesNotContain("\"pictures\"", driver.Labels()[^1], StringComparison.Ordinal);
    }

    [Fact]
    public void Masks_from_rays_are_shown_and_logged_once_it_is_known()
    {
        using var driver = new ScriptDriver(Ini);
        driver.Screen.ShowsHiding = false;
        HarvestTests.Street(driver.Game);
        driver.Press(Keys.J);
        driver.Until(() => driver.Game.Texts.Any(text => text.StartsWith("Masks come from rays: ", StringComparison.Ordinal)));

        Assert.Contains(
            driver.Game.Texts,
            text => text.StartsWith("REC  ", StringComparison.Ordinal) && text.Contains("  MASKS FROM RAYS", StringComparison.Ordinal)
        );
        Assert.Contains("Masks come from rays: ", driver.Log(), StringComparison.Ordinal);
    }

    [Fact]
    public void Occupants_are_hidden_and_shown_with_their_vehicle()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        int vehicle = driver.Game.HandleOf(driver.Game.Vehicles.First(each => driver.Game.HandleOf(each) != driver.Game.PlayersVehicle));
        GameEntity[] occupants =
        [
            .. Enumerable
                .Range(0, 2)
                .Select(_ => new GameEntity
                {
                    Pool = PoolKind.Peds,
                    Name = "a_m_y_hipster_01",
                    Pose = driver.Game.Entities[vehicle].Pose,
                    Vehicle = vehicle,
                }),
        ];
        Array.ForEach(occupants, occupant => driver.Game.Add(occupant));
        driver.Press(Keys.J);
        int hidden = 0;
        driver.Until(() =>
        {
            bool isHidden = driver.Game.Entities[vehicle].IsHidden;
            hidden += isHidden ? 1 : 0;
            Assert.All(occupants, occupant => Assert.Equal(isHidden, occupant.IsHidden));
            return hidden > 0 && !isHidden;
        });
    }

    [Fact]
    public void Occupant_hidden_by_another_mod_stays_hidden()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        int vehicle = driver.Game.HandleOf(driver.Game.Vehicles.First(each => driver.Game.HandleOf(each) != driver.Game.PlayersVehicle));
        var occupant = new GameEntity
        {
            Pool = PoolKind.Peds,
            Name = "a_m_y_hipster_01",
            Pose = driver.Game.Entities[vehicle].Pose,
            Vehicle = vehicle,
            IsHidden = true,
        };
        driver.Game.Add(occupant);
        driver.Press(Keys.J);
        driver.Until(() => driver.Game.Entities[vehicle].IsHidden);
        driver.Until(() => !driver.Game.Entities[vehicle].IsHidden);

        Assert.True(occupant.IsHidden);
    }

    [Fact]
    public void Trailer_and_attached_objects_are_hidden_with_their_vehicle()
    {
        // Only cars are labelled, so the trailer is no object of its own.
        using var driver = new ScriptDriver(Ini + "Classes = car\n");
        (GameEntity vehicle, GameEntity trailer) = WithTrailer(driver.Game);
        GameEntity[] carried =
        [
            Prop(driver.Game, trailer, isAttached: true),
            Prop(driver.Game, vehicle, isAttached: true),
            new()
            {
                Pool = PoolKind.Peds,
                Name = "a_m_y_hipster_01",
                Pose = vehicle.Pose,
                Vehicle = driver.Game.HandleOf(vehicle),
            },
        ];
        driver.Game.Add(carried[2]);
        GameEntity phone = Prop(driver.Game, carried[2], isAttached: true);
        GameEntity beside = Prop(driver.Game, vehicle, isAttached: false);
        GameEntity passer = driver.Game.Entities.Values.First(each => each.Name == "a_m_y_hipster_01" && each.Vehicle == 0);
        HarvestTests.SunkenCar(driver.Game);
        driver.Press(Keys.J);
        int hidden = 0;
        driver.Until(() =>
        {
            hidden += vehicle.IsHidden ? 1 : 0;
            Assert.All([trailer, phone, .. carried], part => Assert.Equal(vehicle.IsHidden, part.IsHidden));
            Assert.False(beside.IsHidden || passer.IsHidden);
            return hidden > 0 && !vehicle.IsHidden;
        });
    }

    [Fact]
    public void Labelled_trailer_is_hidden_on_its_own()
    {
        using var driver = new ScriptDriver(Ini);
        (GameEntity vehicle, GameEntity trailer) = WithTrailer(driver.Game);
        driver.Press(Keys.J);
        driver.Until(() => trailer.IsHidden && !vehicle.IsHidden);
        driver.Until(() => vehicle.IsHidden && !trailer.IsHidden);
    }

    [Fact]
    public void Object_in_the_hand_of_a_person_is_hidden_with_the_person()
    {
        using var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        GameEntity person = driver.Game.Entities.Values.First(each => each.Pool == PoolKind.Peds && each.Name == "a_m_y_hipster_01");
        GameEntity umbrella = Prop(driver.Game, person, isAttached: true);
        driver.Press(Keys.J);
        int hidden = 0;
        driver.Until(() =>
        {
            hidden += person.IsHidden ? 1 : 0;
            Assert.Equal(person.IsHidden, umbrella.IsHidden);
            return hidden > 0 && !person.IsHidden;
        });
    }

    [Theory]
    [MemberData(nameof(Natives))]
    public void Everything_is_shown_after_a_fault(Hash broken)
    {
        using var driver = Harvesting();
        driver.Until(() => IsAnyHidden(driver));
        driver.Game.Fault = native => native == broken ? new InvalidOperationException("The native is broken.") : null;
        driver.UntilMessage("The native is broken.");
        driver.Game.Fault = _ => null;
        driver.Script.RaiseAborted();
        driver.WaitForDisk();

        Assert.False(IsAnyHidden(driver));
    }

    /// <summary>A script that harvests a street with masks from photographs. A prop stands beside one of the vehicles.</summary>
    internal static ScriptDriver Harvesting()
    {
        var driver = new ScriptDriver(Ini);
        HarvestTests.Street(driver.Game);
        Prop(driver.Game, driver.Game.Vehicles.First(each => driver.Game.HandleOf(each) != driver.Game.PlayersVehicle), isAttached: false);
        driver.Press(Keys.J);
        return driver;
    }

    /// <summary>A vehicle of the street with a trailer 6 m behind it.</summary>
    private static (GameEntity Vehicle, GameEntity Trailer) WithTrailer(TestGame game)
    {
        HarvestTests.Street(game);
        GameEntity vehicle = game.Vehicles.First(each => game.HandleOf(each) != game.PlayersVehicle);
        var trailer = new GameEntity
        {
            Pool = PoolKind.Vehicles,
            Name = "trailersmall",
            Pose = vehicle.Pose with { Position = vehicle.Pose.Position + new Vector3D(3, 6, 0) },
        };
        vehicle.Trailer = game.Add(trailer);
        return (vehicle, trailer);
    }

    /// <summary>A prop 0.5 m above an entity.</summary>
    private static GameEntity Prop(TestGame game, GameEntity carrier, bool isAttached)
    {
        var prop = new GameEntity
        {
            Pool = PoolKind.Props,
            Name = "prop_box_wood01a",
            Pose = carrier.Pose with { Position = carrier.Pose.Position + new Vector3D(0, 0, 0.5) },
            AttachedTo = isAttached ? game.HandleOf(carrier) : 0,
        };
        game.Add(prop);
        return prop;
    }

    private static bool IsAnyHidden(ScriptDriver driver) => driver.Game.Entities.Values.Any(entity => entity.IsHidden);

    private static string List(ScriptDriver driver) => Path.Combine(driver.Folder, "GtaDataHarvester.hidden");
}
