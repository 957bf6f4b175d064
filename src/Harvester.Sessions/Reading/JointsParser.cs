using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Reading;

/// <summary>Reads the joints of an object, as docs/dataset-format.md describes them.</summary>
internal static class JointsParser
{
    /// <exception cref="DatasetFormatException">The joints are not those of a person, or not in their order.</exception>
    public static JointsLabel Parse(JsonFields label)
    {
        IReadOnlyList<JsonFields> joints = label.List("joints");
        JointLabel[] read = [.. joints.Select(ReadJoint)];
        if (!joints.Select(joint => joint.Text("joint")).SequenceEqual(JointNames.All, StringComparer.Ordinal))
        {
            throw new DatasetFormatException(
                $"joints must be the {Skeleton.Count} joints in their order: {string.Join(", ", JointNames.All)}."
            );
        }

        return new JointsLabel(read, label.Has("box2dJoints") ? FrameLabelParser.ReadBox(label, "box2dJoints") : null);
    }

    private static JointLabel ReadJoint(JsonFields joint)
    {
        double[]? pixel = joint.Has("pixel") ? joint.Numbers("pixel", 2) : null;
        return new JointLabel(
            joint.Vector("position"),
            pixel is null ? null : new Vector2D(pixel[0], pixel[1]),
            joint.Name<JointVisibility>("visibility")
        );
    }
}
