using Harvester.Geometry;
using Harvester.Simulation.Models;
using Harvester.Simulation.Settings;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>Places of replayed things between steps, and on the ground.</summary>
internal static class ReplayedPlace
{
    /// <summary>Distance of the places before and behind a thing from which the slope of the ground follows, metres: that of the axles of a
    /// car.</summary>
    private const double HalfBase = 1.4;

    /// <summary>A steeper slope is a step between roads, as of a bridge, not one on which a car stands.</summary>
    private const double MaxSlope = 0.35;

    /// <summary>The state between two steps: linear, the heading over the smaller angle; null unless it is there at both.</summary>
    /// <param name="states">The states.</param>
    /// <param name="step">The earlier step.</param>
    /// <param name="part">0 for that step to 1 for the next.</param>
    public static ReplayState? Between(IReadOnlyList<ReplayState?> states, int step, double part)
    {
        if (states[step] is not { } before || part <= 0)
        {
            return states[step];
        }

        if (states[step + 1] is not { } after)
        {
            return part >= 1 ? states[step + 1] : null;
        }

        double turn = Math.IEEERemainder(after.Heading - before.Heading, 2 * Math.PI);
        return new ReplayState(
            before.Centre + ((after.Centre - before.Centre) * part),
            before.Heading + (turn * part),
            (before.Velocity * (1 - part)) + (after.Velocity * part)
        );
    }

    /// <summary>The box of a model with its rider, in its frame, metres.</summary>
    public static (Vector3D Min, Vector3D Max) ExtentsOf(Model model) =>
        model.Riders.Count == 0
            ? (model.Min, model.Max)
            : (
                new Vector3D(
                    Math.Min(model.Min.X, model.Riders[0].Min.X),
                    Math.Min(model.Min.Y, model.Riders[0].Min.Y),
                    Math.Min(model.Min.Z, model.Riders[0].Min.Z)
                ),
                new Vector3D(
                    Math.Max(model.Max.X, model.Riders[0].Max.X),
                    Math.Max(model.Max.Y, model.Riders[0].Max.Y),
                    Math.Max(model.Max.Z, model.Riders[0].Max.Z)
                )
            );

    /// <summary>The pose of a model's origin with the middle of its box where the state has it, on the ground, with its slope.</summary>
    public static Pose PoseOf(ReplayState state, Model model, StagedGround ground)
    {
        var level = new Vector3D(Math.Cos(state.Heading), Math.Sin(state.Heading), 0);
        (Vector3D min, Vector3D max) = ExtentsOf(model);
        double HeightAt(Vector3D place) => ground.At(place).Height;

        // The slope follows from the ground before and behind the middle: tan = (front - rear) / distance.
        Vector3D foot = state.Centre with
        {
            Z = state.Centre.Z + ((min.Z - max.Z) / 2),
        };
        double slope = (HeightAt(foot + (level * HalfBase)) - HeightAt(foot - (level * HalfBase))) / (2 * HalfBase);
        slope = Math.Abs(slope) > MaxSlope || model.Skeletons.Count > 0 ? 0 : slope;
        Axes axes = Horizontal.AxesAlong((level + (Horizontal.Up * slope)).Normalized());

        // The origin lies where the middle of the box comes to the recorded place on the ground plan; its lower end stands on the ground.
        Vector3D middle = axes.ToWorld((min + max) * 0.5);
        Vector3D origin = foot - (middle with { Z = 0 });
        Vector3D below = origin + (axes.Up * model.Min.Z);
        double height = HeightAt(below with { Z = foot.Z });
        return new Pose(origin with { Z = height - (axes.Up.Z * model.Min.Z) }, axes);
    }
}
