using Harvester.Geometry;
using Harvester.Sessions.Scenes;
using Harvester.Simulation.Models;
using Harvester.Simulation.Rendering;
using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>The traffic lights at junctions, which show whose turn it is.</summary>
internal sealed class SignalProps(Signals signals, HandleCounter handles)
{
    private readonly List<(Prop Prop, Junction? Junction, RoadArm Arm)> _lights = [];

    /// <summary>The overridden lights by handle. Traffic follows the regular turns all the same.</summary>
    public Dictionary<int, SignalState> Driven { get; } = [];

    /// <summary>The lights, each with the junction and the arm whose traffic it holds back; no junction for one that holds back
    /// none.</summary>
    public IReadOnlyList<(Prop Prop, Junction? Junction, RoadArm Arm)> Lights => _lights;

    public IEnumerable<EntityState> States => _lights.Select(light => light.Prop.State);

    /// <summary>Adds a light at the right of each stop line, and one on an arm behind the junction for wide roads.</summary>
    public void AddAtStopLines(StreetIndex index, ModelCatalogue catalogue)
    {
        foreach (Junction junction in signals.Junctions)
        {
            foreach (RoadArm arm in junction.Arms.Where(arm => !arm.Road.IsTooShortToWait && arm.Road.Layout.Lanes(!arm.AtStart) > 0))
            {
                AddAtStopLine(junction, arm, index, catalogue);
            }
        }
    }

    /// <summary>Adds lights at given positions, each assigned to the arm of the nearest junction whose traffic it faces.</summary>
    public void AddGiven(IEnumerable<PropPlacement> placements, ModelCatalogue catalogue)
    {
        const double farthest = 45;
        foreach (PropPlacement placement in placements)
        {
            Pose pose = new(placement.Position, Axes.FromEuler(placement.Rotation));
            Junction? junction = signals
                .Junctions.Where(junction => (junction.Position - pose.Position).Length < farthest)
                .MinBy(junction => (junction.Position - pose.Position).Length);
            RoadArm arm =
                junction?.Arms.OrderBy(arm => arm.Road.IsTooShortToWait).ThenBy(arm => arm.Outward.Dot(pose.Axes.Forward)).First()
                ?? default;
            Model model = catalogue.TrafficLights.FirstOrDefault(light => light.Name == placement.Name) ?? catalogue["prop_traffic_01b"];
            Add(model, pose, junction, arm);
        }
    }

    /// <summary>The mesh instances of the lights at a time.</summary>
    public IEnumerable<MeshInstance> Instances(double timeSeconds) =>
        _lights.Select(light => new MeshInstance(
            light.Prop.Model.Variant((int)StateAt(light, timeSeconds)),
            light.Prop.Pose,
            light.Prop.Handle
        ));

    /// <summary>The state of a light at a time; null if the handle is not that of a light.</summary>
    public SignalState? StateAt(int handle, double timeSeconds)
    {
        int index = _lights.FindIndex(light => light.Prop.Handle == handle);
        return index < 0 ? null : StateAt(_lights[index], timeSeconds);
    }

    private SignalState StateAt((Prop Prop, Junction? Junction, RoadArm Arm) light, double timeSeconds) =>
        Driven.TryGetValue(light.Prop.Handle, out SignalState driven) ? driven
        : light.Junction is null ? SignalState.Green
        : signals.ColourFor(light.Junction, light.Arm, timeSeconds);

    private void AddAtStopLine(Junction junction, RoadArm arm, StreetIndex index, ModelCatalogue catalogue)
    {
        TryAdd(junction, arm, arm, isDrivingAway: false, index, catalogue["prop_traffic_03a"]);
        RoadArm opposite = junction.Arms.MinBy(other => other.Outward.Dot(arm.Outward));
        const double straightOn = -0.8;
        if (arm.Road.Layout.Lanes(!arm.AtStart) > 1 && opposite.Outward.Dot(arm.Outward) < straightOn)
        {
            TryAdd(junction, arm, opposite, isDrivingAway: true, index, catalogue["prop_traffic_01b"]);
        }
    }

    /// <summary>Adds a light for an arm's traffic to the right of it, on that arm or behind the junction on another.</summary>
    private void TryAdd(Junction junction, RoadArm arm, RoadArm on, bool isDrivingAway, StreetIndex index, Model model)
    {
        const double besideKerb = 0.8;
        const double step = 1.5;
        const int steps = 6;
        bool drivesAlong = on.AtStart == isDrivingAway;
        double offset = drivesAlong ? on.Road.RightKerb + besideKerb : on.Road.LeftKerb - besideKerb;
        for (int i = 0; i < steps && on.Trim + (i * step) < on.Road.Length; i++)
        {
            double distance = on.DistanceAt(on.Trim + (i * step));
            Vector3D place = on.Road.Curve.OffsetAt(distance, offset);
            if (!index.IsOnAnother(on.Road, place, besideKerb))
            {
                Vector3D tangent = on.Road.Curve.TangentAt(distance);
                Vector3D level = new Vector3D(tangent.X, tangent.Y, 0).Normalized();
                Vector3D foot = place + (Horizontal.Up * Walkway.KerbHeight);
                Add(model, new Pose(foot, Horizontal.AxesAlong(drivesAlong ? level : -level)), junction, arm);
                return;
            }
        }
    }

    private void Add(Model model, Pose pose, Junction? junction, RoadArm arm) =>
        _lights.Add((new Prop(handles.Next(), model, 0, pose), junction, arm));
}
