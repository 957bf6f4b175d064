using Harvester.Capture.Labelling;
using Harvester.Capture.Ports;
using Harvester.Driving.Bridge;
using Harvester.Driving.Controllers;
using Harvester.Geometry;
using Harvester.Geometry.Cameras;
using Harvester.Geometry.Lanes;
using Harvester.Geometry.Roads;
using Harvester.Sessions.Imaging;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Scenes;

namespace Harvester.Driving.Session;

/// <summary>What a client sees: the image, and the car with the lanes around it. The image's memory is reused.</summary>
internal sealed class DrivingView
{
    /// <summary>Vehicles whose origins lie this far beyond the indicators' range may still reach into it, metres.</summary>
    private const double MaxHalfVehicle = 10;

    private readonly GamePorts _game;
    private readonly LaneTracker? _lanes;
    private LaneSection _section = new(1, RoadGeometry.LaneWidth);
    private bool _isFast;

    public DrivingView(GamePorts game, ImageSize picture)
    {
        _game = game;
        _lanes = game.Roads is { } roads ? new LaneTracker(roads, static entity => entity.Handle) : null;
        Picture = new PixelBuffer(picture);
    }

    /// <summary>The last image.</summary>
    public PixelBuffer Picture { get; }

    /// <summary>Whether the newest frame has an image.</summary>
    public bool HasPicture { get; private set; }

    /// <summary>Whether the lanes were known when the last image was taken.</summary>
    public bool AreLanesKnown { get; private set; }

    /// <summary>Reads what only a simulated game knows; null in GTA V.</summary>
    public Func<DrivingTruth>? ReadTruth { get; init; }

    /// <summary>Takes image and state of this tick.</summary>
    /// <param name="frame">Number of the frame.</param>
    /// <param name="hasPicture">Whether an image is wanted.</param>
    /// <param name="refusal">Why the image cannot be used; null if it can.</param>
    /// <returns>Null if the image cannot be used.</returns>
    public BridgeState? Take(long frame, bool hasPicture, out string? refusal)
    {
        refusal = hasPicture ? _game.Screen.Grab(Picture).Refusal : null;
        if (refusal is not null)
        {
            return null;
        }

        EgoState ego = _game.World.ReadEgo();
        LanesLabel? lanes = ReadLanes(ego);
        _isFast = lanes?.IsFast ?? false;
        AreLanesKnown = lanes?.Status == LaneStatus.Known;
        HasPicture = hasPicture;
        return new BridgeState(
            frame,
            _game.World.TimeSeconds,
            ego.Velocity.Length,
            ego.Pose.Position,
            Angles.HeadingDegrees(ego.Pose.Axes.Forward),
            lanes?.Indicators ?? LaneIndicators.Unknown,
            lanes?.TorcsEquivalent ?? LaneIndicators.Unknown,
            _isFast
        )
        {
            AreLanesKnown = AreLanesKnown,
            HasPicture = hasPicture,
            Truth = ReadTruth?.Invoke(),
        };
    }

    /// <summary>
    /// The controller's input when a client has estimated the indicators from an image. Lane width and straightness are the last known ones
    /// of the road.
    /// </summary>
    public DrivingState StateOf(LaneIndicators torcsEquivalent)
    {
        EgoState ego = _game.World.ReadEgo();
        return new DrivingState(TorcsEquivalent.InMetres(torcsEquivalent, _section), torcsEquivalent, _isFast, ego.Velocity.Length)
        {
            HeadingRadians = Angles.ToRadians(Angles.HeadingDegrees(ego.Pose.Axes.Forward)),
            PedalsInForce = DrivingState.PedalsOf(ego),
        };
    }

    /// <summary>Discards the car's position.</summary>
    public void Reset() => _lanes?.Reset();

    private LanesLabel? ReadLanes(EgoState ego)
    {
        if (_lanes is null)
        {
            return null;
        }

        IReadOnlyList<EntityState> entities = _game.World.ReadEntities(
            ego.Pose.Position,
            IndicatorCalculator.VehicleRange + MaxHalfVehicle
        );
        if (_lanes.Observe(ego, entities) is not { } known)
        {
            return null;
        }

        _section = known.Seen.Section ?? _section;
        return LanesLabel.Of(known.Seen, known.Roads.Source, [], null);
    }
}
