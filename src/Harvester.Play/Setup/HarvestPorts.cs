using Harvester.Capture.Ports;
using Harvester.Play.Features;
using Harvester.Play.Settings;
using Harvester.Play.Surveys.Roads;

namespace Harvester.Play.Setup;

/// <summary>What harvests, drives and surveys see of the game, and the features behind it that have something to do in each tick.</summary>
internal sealed class HarvestPorts
{
    /// <summary>Makes the ports; the game is not used yet.</summary>
    /// <param name="setup">The settings, and what the features share.</param>
    /// <param name="adapters">The game.</param>
    /// <param name="features">The features, most of which are made later.</param>
    /// <param name="rules">When pictures are taken.</param>
    public HarvestPorts(ModSetup setup, IGameAdapters adapters, ModFeatures features, FeatureRules rules)
    {
        PlayerSettings player = setup.Player;
        Scene = adapters.SceneAround(features.Mount, () => features.Harvest.Faces, () => features.Harvest.HasRig);
        Hidden = new HiddenEntities(
            adapters.ShownEntities,
            setup.Folder.HiddenPath,
            setup.Messages,
            () => features.Harvest.IsOn || features.SelfTest.IsOn
        );
        Hud = new HiddenHud(adapters.Hud, adapters.Display, rules.TakesPictures);
        Markers = new DrawnMarkers(adapters.Display);
        Sheets = new DrawnSheets(adapters.Display);
        Card = new DrawnCard(adapters.Display);
        Roads = new GrowingRoads(player.LaneWidthMetres, player.NarrowLaneWidthMetres);
        Lights = new LightControl(
            Scene.World,
            adapters.TrafficLights,
            player.LightOrder,
            player.Options.RangeMetres,
            player.Options.MaxPictureLagTicks + 2
        )
        {
            IsWanted = () => player.DrivesLights && features.Harvest.IsOn,
        };
        Sky = new PlayerSky(adapters.Controls, Scene.World) { Kept = () => features.Plan?.Weather };
        Actors = new StagedActors(adapters.Actors, adapters.Models, setup.Clock, setup.Messages);
        Game = new GamePorts(Scene.World, adapters.Rays, setup.Screen, adapters.Time, setup.Clock, Markers)
        {
            Roads = Roads,
            Paint = player.PaintFile is null ? null : Roads,
            Lights = Lights,
            MountedCamera = features.Mount,
            RigCamera = features.Mount,
            SurfaceRays = adapters.Rays,
            Visibility = Hidden,
            Sky = Sky,
            Sheets = Sheets,
            Hud = Hud,
            Stage = Actors,
            Card = Card,
            Calls = adapters.Calls,
            Reading = adapters.Reading,
        };
    }

    /// <summary>All ports.</summary>
    public GamePorts Game { get; }

    /// <summary>The readers of the scene.</summary>
    public GameScene Scene { get; }

    /// <summary>The actors of scenarios.</summary>
    public StagedActors Actors { get; }

    /// <summary>Hides entities.</summary>
    public HiddenEntities Hidden { get; }

    /// <summary>Sets weather and time of day for pictures.</summary>
    public PlayerSky Sky { get; }

    /// <summary>Hides radar and head-up display.</summary>
    public HiddenHud Hud { get; }

    /// <summary>Draws the markers of calibrations.</summary>
    public DrawnMarkers Markers { get; }

    /// <summary>Draws screens behind objects.</summary>
    public DrawnSheets Sheets { get; }

    /// <summary>Draws known colours.</summary>
    public DrawnCard Card { get; }

    /// <summary>The roads known so far.</summary>
    public GrowingRoads Roads { get; }

    /// <summary>Drives traffic lights.</summary>
    public LightControl Lights { get; }
}
