using Harvester.Geometry;

namespace Harvester.Sessions.Scenes;

/// <summary>The positions of a person's joints. Two skeletons with the same positions are equal.</summary>
public sealed class Skeleton : IEquatable<Skeleton>
{
    /// <summary>The number of joints.</summary>
    public const int Count = 22;

    private readonly Vector3D[] _joints;

    /// <summary>Takes the positions in the order of <see cref="Joint"/>, metres.</summary>
    /// <exception cref="ArgumentException">There are more or fewer than 22.</exception>
    public Skeleton(IEnumerable<Vector3D> joints)
        : this([.. joints ?? throw new ArgumentNullException(nameof(joints))]) { }

    private Skeleton(Vector3D[] joints) =>
        _joints =
            joints.Length == Count
                ? joints
                : throw new ArgumentException($"A skeleton has {Count} joints, not {joints.Length}.", nameof(joints));

    /// <summary>The positions in the order of <see cref="Joint"/>.</summary>
    public IReadOnlyList<Vector3D> Joints => _joints;

    /// <summary>The position of a joint.</summary>
    public Vector3D this[Joint joint] => _joints[(int)joint];

    /// <summary>The same skeleton moved from a frame of its own to the world.</summary>
    public Skeleton MovedBy(Pose pose)
    {
        var moved = new Vector3D[Count];
        for (int i = 0; i < Count; i++)
        {
            moved[i] = pose.ToWorld(_joints[i]);
        }

        return new Skeleton(moved);
    }

    /// <summary>The crown, which the game has no bone for: as far beyond the head's bone as that is from the neck's, as in JTA.</summary>
    public static Vector3D CrownOf(Vector3D neck, Vector3D head) => head + (head - neck);

    /// <inheritdoc/>
    public bool Equals(Skeleton? other) => other is not null && _joints.SequenceEqual(other._joints);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => Equals(obj as Skeleton);

    /// <inheritdoc/>
    public override int GetHashCode() => _joints[0].GetHashCode();
}
