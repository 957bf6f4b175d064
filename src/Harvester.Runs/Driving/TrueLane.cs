using Harvester.Geometry;
using Harvester.Runs.Evaluation.Figures;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Streets;

namespace Harvester.Runs.Driving;

/// <summary>The true place of a car on the roads of a simulated game.</summary>
/// <param name="Placement">Its place across the lanes of its direction; null in a junction.</param>
/// <param name="Angle">Angle from the car to its road, radians, positive if the road points to the left; null in a junction and off the
/// roads.</param>
public readonly record struct TrueLane(LanePlacement? Placement, double? Angle)
{
    /// <summary>Locates a car.</summary>
    public static TrueLane Of(RoadTruth truth, EgoState ego)
    {
        Vector3D centre = ego.Pose.ToWorld((ego.ModelMin + ego.ModelMax) * 0.5);
        double halfWidth = (ego.ModelMax.X - ego.ModelMin.X) / 2;
        double halfLength = (ego.ModelMax.Y - ego.ModelMin.Y) / 2;
        return truth.Locate(centre, ego.Pose.Axes.Forward) switch
        {
            { IsInJunction: true } => default,
            { } at => new TrueLane(
                new LanePlacement(
                    at.Road,
                    at.Lane,
                    at.Lanes,
                    at.LaneWidth,
                    at.RightOfLaneCentre,
                    (halfWidth * Math.Cos(at.AngleToRoad)) + (halfLength * Math.Abs(Math.Sin(at.AngleToRoad)))
                ),
                at.AngleToRoad
            ),
            null => new TrueLane(new LanePlacement(-1, null, 0, 0, 0, halfWidth), null),
        };
    }
}
