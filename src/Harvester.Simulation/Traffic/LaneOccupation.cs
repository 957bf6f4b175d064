using Harvester.Simulation.Streets;

namespace Harvester.Simulation.Traffic;

/// <summary>The vehicles on each path at the beginning of a tick.</summary>
internal sealed class LaneOccupation(LaneGraph lanes)
{
    private readonly List<Vehicle>?[] _vehicles = new List<Vehicle>?[lanes.Paths.Count];
    private readonly List<int> _used = [];

    /// <summary>Stays empty.</summary>
    private static readonly List<Vehicle> Nobody = [];

    public void Refresh(IReadOnlyList<Vehicle> vehicles)
    {
        foreach (int path in _used)
        {
            _vehicles[path]!.Clear();
        }

        _used.Clear();
        foreach (Vehicle vehicle in vehicles)
        {
            foreach (LanePath way in vehicle.Ways)
            {
                List<Vehicle> list = _vehicles[way.Index] ??= [];
                if (list.Count == 0)
                {
                    _used.Add(way.Index);
                }

                list.Add(vehicle);
            }
        }
    }

    public List<Vehicle> On(LanePath path) => _vehicles[path.Index] ?? Nobody;
}
