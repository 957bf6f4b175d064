using Foxglove;
using Google.Protobuf;
using Google.Protobuf.Reflection;
using Gtaharvest;

namespace Harvester.Exports.Formats.Mcap;

/// <summary>
/// The protobuf schemas of the channels, from the files in Schemas: Foxglove's, so that its app and others show the messages
/// (docs.foxglove.dev, "Message schemas"; names, numbers and types of the fields in github.com/foxglove/foxglove-sdk), and those of the
/// lane indicators and of recorded drives.
/// </summary>
internal static class MessageSchemas
{
    private static readonly Dictionary<string, MessageDescriptor> Messages = new MessageDescriptor[]
    {
        CompressedImage.Descriptor,
        CameraCalibration.Descriptor,
        FrameTransforms.Descriptor,
        SceneUpdate.Descriptor,
        ImageAnnotations.Descriptor,
        LaneIndicators.Descriptor,
        DriveAction.Descriptor,
        Gtaharvest.DriveTick.Descriptor,
        Imu.Descriptor,
        OpenEvents.Descriptor,
        Grid.Descriptor,
        RawImage.Descriptor,
        Foxglove.PointCloud.Descriptor,
        Foxglove.VoxelGrid.Descriptor,
    }.ToDictionary(message => message.FullName, StringComparer.Ordinal);

    /// <summary>Full name of the message of points, which only rigs have.</summary>
    public const string PointCloud = "foxglove.PointCloud";

    /// <summary>
    /// Full names of the messages of the channels, each once. That of voxels, the newest, is last, so that the others keep their numbers.
    /// </summary>
    public static IReadOnlyList<string> Names { get; } =
    [
        .. McapChannel
            .All.Except(McapChannel.OfVoxels)
            .Select(channel => channel.Schema)
            .Append(PointCloud)
            .Concat(McapChannel.OfVoxels.Select(channel => channel.Schema))
            .Distinct(StringComparer.Ordinal),
    ];

    /// <summary>A serialised FileDescriptorSet with the file of a message after all files that it imports.</summary>
    public static byte[] DescriptorsOf(string message)
    {
        var set = new FileDescriptorSet();
        var added = new HashSet<string>(StringComparer.Ordinal);
        Add(Messages[message].File);
        return set.ToByteArray();

        void Add(FileDescriptor file)
        {
            if (added.Add(file.Name))
            {
                foreach (FileDescriptor import in file.Dependencies)
                {
                    Add(import);
                }

                set.File.Add(file.ToProto());
            }
        }
    }
}
