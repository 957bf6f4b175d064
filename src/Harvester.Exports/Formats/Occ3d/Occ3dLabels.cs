using Harvester.Geometry.Grids;
using Harvester.Sessions.Labels;
using Harvester.Sessions.Reading.Files;
using Harvester.Sessions.Rigs;
using Harvester.Sessions.Semantics;

namespace Harvester.Exports.Formats.Occ3d;

/// <summary>
/// The arrays of a labels.npz, whose axes are those of the ego's frame: x forward, y to the left, z up, each from its least value.
/// </summary>
/// <param name="Semantics">The class of each voxel.</param>
/// <param name="LidarMask">1 where a beam of a LiDAR passes or ends, else 0.</param>
/// <param name="CameraMask">1 where a camera sees the voxel, else 0.</param>
internal sealed record Occ3dLabels(byte[] Semantics, byte[] LidarMask, byte[] CameraMask)
{
    /// <summary>Name of the file of a moment.</summary>
    public const string FileName = "labels.npz";

    private static readonly VoxelShape Shape = VoxelShape.Usual;
    private static readonly int[] Axes = [Shape.Cells, Shape.Cells, Shape.Layers];
    private static readonly string[] Names = ["semantics", "mask_lidar", "mask_camera"];

    /// <summary>The labels that a frame has: those of one camera, and of the LiDARs with the first view.</summary>
    /// <exception cref="DatasetFormatException">A map or the points cannot be read, or the box of voxels has another size.</exception>
    public static Occ3dLabels Of(ExportFrame frame, OccupancyLabel label)
    {
        if (label.Shape != Shape)
        {
            throw frame.Problem(
                FormattableString.Invariant($"its voxels are not {Shape.Cells} x {Shape.Cells} x {Shape.Layers} of {Shape.CellMetres} m ")
                    + FormattableString.Invariant($"from {Shape.LowestMetres} m on, and occ3d has no others.")
            );
        }

        ushort[] classes = frame.ReadVoxels(label.File, Shape);
        ushort[] owners = frame.ReadVoxels(label.Instances, Shape, hasIds: true);
        ushort[] visible = frame.ReadVoxels(label.Visible, Shape);
        Riders riders = Riders.At(frame);
        var semantics = new byte[Shape.Count];
        var seen = new byte[Shape.Count];
        int at = 0;

        // Rows go backwards along x, and columns to the right, against y.
        for (int row = Shape.Cells - 1; row >= 0; row--)
        {
            for (int column = Shape.Cells - 1; column >= 0; column--)
            {
                for (int layer = 0; layer < Shape.Layers; layer++, at++)
                {
                    int voxel = (((layer * Shape.Cells) + row) * Shape.Cells) + column;
                    semantics[at] =
                        classes[voxel] == (ushort)SemanticClass.Rider
                            ? Occ3dClasses.OfRider(riders.VehicleOf(owners[voxel])?.Class)
                            : Occ3dClasses.Of(classes[voxel]);
                    seen[at] = visible[voxel] == OccupancyLabel.Seen ? (byte)1 : (byte)0;
                }
            }
        }

        return new Occ3dLabels(semantics, BeamsOf(frame, label), seen);
    }

    /// <summary>Writes the file.</summary>
    public void Write(Stream stream) => NpzFile.Write(stream, Axes, (Names[0], Semantics), (Names[1], LidarMask), (Names[2], CameraMask));

    /// <summary>Writes the file of a moment: what any camera or LiDAR sees, is seen.</summary>
    /// <param name="stream">Where to.</param>
    /// <param name="views">The files of its views.</param>
    /// <exception cref="DatasetFormatException">One of them is damaged.</exception>
    public static void Merge(Stream stream, IEnumerable<byte[]> views)
    {
        Occ3dLabels? all = null;
        foreach (byte[] bytes in views)
        {
            using var file = new MemoryStream(bytes);
            Occ3dLabels view =
                Read(file)
                ?? throw new DatasetFormatException("A staged file of the export is damaged. Delete the folder and export again.");
            all ??= view;
            for (int at = 0; at < all.Semantics.Length; at++)
            {
                all.LidarMask[at] |= view.LidarMask[at];
                all.CameraMask[at] |= view.CameraMask[at];
            }
        }

        all!.Write(stream);
    }

    /// <summary>What is wrong with a file; null if nothing is.</summary>
    public static string? ProblemOf(Stream stream) =>
        Read(stream) is not { } labels
            ? $"it does not have {string.Join(", ", Names)} of {Shape.Cells} x {Shape.Cells} x {Shape.Layers} unsigned bytes."
        : Array.Exists(labels.Semantics, static value => value > Occ3dClasses.Free)
            ? $"{Names[0]} has a value above {Occ3dClasses.Free}, which is no class."
        : Array.Exists(labels.LidarMask, static value => value > 1) ? $"{Names[1]} has a value other than 0 and 1."
        : Array.Exists(labels.CameraMask, static value => value > 1) ? $"{Names[2]} has a value other than 0 and 1."
        : null;

    private static Occ3dLabels? Read(Stream stream) =>
        NpzFile.Read(stream, Axes, Names) is { } arrays ? new Occ3dLabels(arrays[0], arrays[1], arrays[2]) : null;

    private static byte[] BeamsOf(ExportFrame frame, OccupancyLabel label)
    {
        var beams = new VoxelBeams(Shape, label.Origin);
        foreach (SweepLabel sweep in frame.Label.Lidar)
        {
            RigLidar lidar =
                frame.Rig?.Lidars.FirstOrDefault(each => each.Name == sweep.Sensor)
                ?? throw frame.Problem($"its LiDAR '{sweep.Sensor}' is not in the rig.");
            beams.Add(frame.Rig.OnVehicle(lidar.Mount), frame.ReadPoints(sweep));
        }

        return beams.Passed;
    }
}
