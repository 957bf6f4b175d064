using Harvester.Geometry;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Json;
using Harvester.Sessions.Scenes;
using Harvester.Sessions.Text;

namespace Harvester.Exports.Formats.Jta;

/// <summary>Writes JTA's layout: a sequence per place, with one annotation file of joints each. See docs/exports/jta.md.</summary>
internal sealed class JtaWriter : IDatasetWriter
{
    private const string SequencePrefix = "sequence ";
    private const string RowsPrefix = "rows ";
    private const int Decimals = 4;

    public WrittenObjects Write(ExportFrame frame, FrameOutput output)
    {
        string sequence = $"{frame.Split}/seq_{frame.SequenceIndex}";
        output.Image($"frames/{sequence}/{frame.FrameInSequence + 1}{frame.ImageExtension}", frame);
        output.Part(SequencePrefix + sequence, $"{frame.FrameInSequence}");
        if (frame.FrameInSequence == 0)
        {
            output.Text($"cameras/{sequence}.json", Camera(frame.Label.Camera) + "\n");
        }

        ObjectLabel[] people =
        [
            .. frame.Objects.Select(item => item.Label).Where(label => VehicleClasses.ArePeople(label.Class) && label.Joints is not null),
        ];
        if (people.Length > 0)
        {
            output.Part(RowsPrefix + sequence, string.Join(",", people.SelectMany(person => Rows(frame, person))));
        }

        return new WrittenObjects(people.Length);
    }

    public IEnumerable<AggregateFile> Aggregates(IReadOnlyDictionary<string, int> parts) =>
        parts
            .Keys.Where(part => part.StartsWith(SequencePrefix, StringComparison.Ordinal))
            .Select(part => part[SequencePrefix.Length..])
            .Select(sequence => new AggregateFile(
                $"annotations/{sequence}.json",
                [AggregateSection.Literal("[\n"), AggregateSection.Joined(RowsPrefix + sequence, ",\n"), AggregateSection.Literal("\n]\n")]
            ));

    /// <summary>One row for each joint in front of the camera, in the order of JTA's columns.</summary>
    private static IEnumerable<string> Rows(ExportFrame frame, ObjectLabel person)
    {
        for (int number = 0; number < Skeleton.Count; number++)
        {
            JointLabel joint = person.Joints!.Joints[number];
            if (joint.Pixel is { } pixel)
            {
                Vector3D inCamera = frame.Label.Camera.Pose.ToLocal(joint.Position);
                double[] row =
                [
                    frame.FrameInSequence + 1,
                    person.Id,
                    number,
                    pixel.X,
                    pixel.Y,
                    inCamera.X,
                    -inCamera.Z,
                    inCamera.Y,
                    joint.Visibility is JointVisibility.Occluded or JointVisibility.Unknown ? 1 : 0,
                    joint.Visibility == JointVisibility.SelfOccluded ? 1 : 0,
                ];
                yield return "[" + string.Join(",", row.Select(value => InvariantNumber.Format(value, Decimals))) + "]";
            }
        }
    }

    /// <summary>The intrinsics, which in JTA are the same for all sequences.</summary>
    private static string Camera(CameraLabel camera) =>
        JsonLine.Of(json =>
        {
            json.WriteStartObject();
            json.Number("fx", camera.Fx, Decimals);
            json.Number("fy", camera.Fy, Decimals);
            json.Number("cx", camera.Cx, Decimals);
            json.Number("cy", camera.Cy, Decimals);
            json.WriteNumber("width", camera.Width);
            json.WriteNumber("height", camera.Height);
            json.WriteEndObject();
        });
}
