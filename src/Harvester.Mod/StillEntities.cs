using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Mod;

/// <summary>
/// The entities as they were read at one moment of the game's time, which a frozen game reads several times. What has the same matrix as
/// before still is what it was, with the velocity that it had.
/// </summary>
internal sealed class StillEntities
{
    private readonly Dictionary<int, (ScaledPose Place, EntityState State)> _states = [];
    private readonly Dictionary<int, (ScaledPose Place, PedRole Role)> _roles = [];
    private readonly Dictionary<int, Skeleton> _joints = [];
    private double _seconds = double.NaN;

    /// <summary>Begins a reading at a moment; what was read at another one is removed.</summary>
    public void Begin(double seconds)
    {
        if (seconds != _seconds)
        {
            Clear();
            _seconds = seconds;
        }
    }

    /// <summary>Removes everything.</summary>
    public void Clear()
    {
        _states.Clear();
        _roles.Clear();
        _joints.Clear();
    }

    /// <summary>An entity as it was read, if it is at the same place; otherwise null.</summary>
    public EntityState? Of(int handle, ScaledPose place) =>
        _states.TryGetValue(handle, out (ScaledPose Place, EntityState State) known) && known.Place == place ? known.State : null;

    /// <summary>What a ped was when it came to its place; null if that is not known.</summary>
    public PedRole? RoleOf(int handle, ScaledPose place) =>
        _roles.TryGetValue(handle, out (ScaledPose Place, PedRole Role) known) && known.Place == place ? known.Role : null;

    /// <summary>The joints of a ped as they were read since it came to its place; null if they were not.</summary>
    public Skeleton? JointsOf(int handle) => _joints.TryGetValue(handle, out Skeleton? joints) ? joints : null;

    /// <summary>Adds an entity that was read.</summary>
    public void Add(ScaledPose place, EntityState state)
    {
        _states[state.Handle] = (place, state);
        _joints.Remove(state.Handle);
    }

    /// <summary>Adds what a ped is at its place.</summary>
    public void Add(int handle, ScaledPose place, PedRole role) => _roles[handle] = (place, role);

    /// <summary>Adds the joints of a ped.</summary>
    public void Add(int handle, Skeleton joints) => _joints[handle] = joints;
}
