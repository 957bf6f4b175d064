using System.Globalization;
using Harvester.Exports.Formats.NuScenes;

namespace Harvester.Exports.Formats.Occ3d;

/// <summary>
/// The scenes of a dataset, each a session at a place, with the numbers that they have in a nuScenes export: those that have a sample count
/// first. They follow from the names of the parts that frames write.
/// </summary>
internal sealed class Occ3dScenes
{
    private const string KeyPrefix = "key ";
    private const string VoxelPrefix = "voxels ";

    private readonly Dictionary<string, int> _numbers = new(StringComparer.Ordinal);
    private readonly string[] _moments;

    /// <summary>Numbers the scenes.</summary>
    /// <param name="parts">The names of all parts.</param>
    public Occ3dScenes(IEnumerable<string> parts)
    {
        string[] names = [.. parts.Order(StringComparer.Ordinal)];
        _moments = [.. names.Where(static name => name.StartsWith(VoxelPrefix, StringComparison.Ordinal))];
        foreach (
            string place in names
                .Where(static name => name.StartsWith(KeyPrefix, StringComparison.Ordinal))
                .Select(static name => name[KeyPrefix.Length..])
                .Concat(_moments.Select(PlaceIn))
        )
        {
            _numbers.TryAdd(place, _numbers.Count);
        }
    }

    /// <summary>The files of voxels with the parts from which they are made.</summary>
    public IEnumerable<(string Path, string Part)> Files =>
        _moments.Select(part =>
        {
            int number = _numbers[PlaceIn(part)];
            int moment = int.Parse(part.AsSpan(part.LastIndexOf(' ') + 1), CultureInfo.InvariantCulture);
            return (Occ3dFiles.LabelsOf(NuScenesScene.NameOf(number), TokenOf(number, moment)), part);
        });

    /// <summary>Name of the part with the voxels of a view: all views of a moment have the same.</summary>
    public static string PartOf(Occ3dView view) => FormattableString.Invariant($"{VoxelPrefix}{PlaceOf(view)} {view.Moment:D8}");

    /// <summary>Name of the part that says that a scene has a sample.</summary>
    public static string KeyOf(Occ3dView view) => KeyPrefix + PlaceOf(view);

    /// <summary>The token of a moment.</summary>
    public static string TokenOf(int scene, int moment) => NuScenesToken.Of("sample", scene, moment);

    /// <summary>The number of the scene of a view.</summary>
    public int NumberOf(Occ3dView view) => _numbers[PlaceOf(view)];

    private static string PlaceOf(Occ3dView view) => FormattableString.Invariant($"{view.Recording:D8} {view.Place:D8}");

    private static string PlaceIn(string part) => part[VoxelPrefix.Length..part.LastIndexOf(' ')];
}
