using Harvester.Geometry;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Labels;

/// <summary>The joints of a person in an image, and the box around them. Two with the same content are equal.</summary>
public sealed class JointsLabel : IEquatable<JointsLabel>
{
    /// <summary>Takes the joints in the order of <see cref="Joint"/>.</summary>
    /// <param name="joints">One label per joint.</param>
    /// <param name="box">The box around the projections of spheres about the joints, pixels; null if a sphere reaches the near
    /// plane.</param>
    /// <exception cref="ArgumentException">There are more or fewer than 22 joints.</exception>
    public JointsLabel(IReadOnlyList<JointLabel> joints, Box2D? box)
    {
        Joints = joints ?? throw new ArgumentNullException(nameof(joints));
        Box = box;
        if (joints.Count != Skeleton.Count)
        {
            throw new ArgumentException($"A person has {Skeleton.Count} joints, not {joints.Count}.", nameof(joints));
        }
    }

    /// <summary>The joints in the order of <see cref="Joint"/>.</summary>
    public IReadOnlyList<JointLabel> Joints { get; }

    /// <summary>The tight amodal box of the person, pixels; null if part of the person is nearer than the near plane.</summary>
    public Box2D? Box { get; }

    /// <summary>A joint.</summary>
    public JointLabel this[Joint joint] => Joints[(int)joint];

    /// <inheritdoc/>
    public bool Equals(JointsLabel? other) => other is not null && Box == other.Box && Joints.SequenceEqual(other.Joints);

    /// <inheritdoc/>
    public override bool Equals(object? obj) => Equals(obj as JointsLabel);

    /// <inheritdoc/>
    public override int GetHashCode() => Joints[0].GetHashCode();
}
