using Harvester.Geometry;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>The ground under staged actors, and the lanes that they block.</summary>
internal sealed class StagedGround
{
    /// <summary>Half of the width that a car on the line of a lane needs, metres.</summary>
    private const double HalfCar = 1.2;

    /// <summary>Half of the width of a way through a junction, metres.</summary>
    private const double HalfWay = 2.7;

    private readonly LaneFinder _finder;
    private readonly Func<Vector3D, double> _land;

    /// <param name="lanes">The lanes.</param>
    /// <param name="land">Height of the land beside the roads, metres.</param>
    public StagedGround(LaneGraph lanes, Func<Vector3D, double> land) => (_finder, _land) = (new LaneFinder(lanes), land);

    /// <summary>Height of the ground at a place, and whether it is a carriageway.</summary>
    public (double Height, bool IsOnRoad) At(Vector3D place) => At(place, [.. _finder.Near(place)]);

    /// <summary>Puts a staged vehicle where its motion has it, with the slope of the ground.</summary>
    public void Stand(Vehicle vehicle)
    {
        StagedMotion motion = vehicle.Staged!;
        List<LanePlace> near = [.. _finder.Near(motion.Ground)];
        motion.Stand(At(motion.Ground, near).Height);
        double slope = 0;
        if (near.Count > 0)
        {
            LanePlace nearest = near.MinBy(place => Math.Abs(place.RightOffset));
            Vector3D tangent = nearest.Path.Line.TangentAt(nearest.Distance);
            slope = tangent.Z / Math.Sqrt(1 - (tangent.Z * tangent.Z)) * Math.Cos(Horizontal.Turn(tangent, motion.Forward));
        }

        Axes axes = Horizontal.AxesAlong((motion.Forward + (Horizontal.Up * slope)).Normalized());
        Vector3D velocity = motion.Velocity;
        vehicle.MoveStaged(
            new Pose(motion.Ground - (axes.Up * vehicle.Model.Min.Z), axes),
            motion.Speed,
            velocity with
            {
                Z = slope * velocity.Dot(motion.Forward),
            },
            near.Where(place => IsBlocked(vehicle, motion, place))
        );
    }

    /// <summary>Whether a body reaches so near to the line of a lane that a car there would touch it.</summary>
    private static bool IsBlocked(Vehicle vehicle, StagedMotion motion, LanePlace place)
    {
        // Half of the body's width across the lane: of a rectangle turned by an angle, (L |sin| + W |cos|) / 2.
        double turn = Horizontal.Turn(place.Path.Line.TangentAt(place.Distance), motion.Forward);
        double width = (vehicle.Model.Max.X - vehicle.Model.Min.X) + (vehicle.OpenDoor == 0 ? 0 : 2 * Models.DoorModel.Reach);
        double across = ((vehicle.Length * Math.Abs(Math.Sin(turn))) + (width * Math.Abs(Math.Cos(turn)))) / 2;
        return Math.Abs(place.RightOffset) - across < HalfCar;
    }

    private (double Height, bool IsOnRoad) At(Vector3D place, List<LanePlace> near)
    {
        if (near.Count == 0)
        {
            return (_land(place), false);
        }

        LanePlace nearest = near.MinBy(lane => Math.Abs(lane.RightOffset));
        double height = nearest.Path.Line.PositionAt(nearest.Distance).Z;
        if (nearest.Path.Road is not { } road)
        {
            return (height, Math.Abs(nearest.RightOffset) < HalfWay);
        }

        double centre = road.Layout.LaneCentre(nearest.Path.IsForward, nearest.Path.Lane);
        double offset = centre + (nearest.Path.IsForward ? nearest.RightOffset : -nearest.RightOffset);
        bool isBeyondKerb = offset < road.LeftKerb || offset > road.RightKerb;
        return (
            height + (isBeyondKerb && road.IsStreet ? Walkway.KerbHeight : 0),
            offset > road.Layout.LeftEdge && offset < road.Layout.RightEdge
        );
    }
}
