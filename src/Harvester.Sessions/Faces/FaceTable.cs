using Harvester.Sessions.Scenes;

namespace Harvester.Sessions.Faces;

/// <summary>The faces of all known models.</summary>
public sealed class FaceTable
{
    /// <summary>Name of the file with the faces that a survey measured.</summary>
    public const string FileName = "spaces.csv";

    private static readonly IReadOnlyList<ModelFace> None = [];
    private readonly Dictionary<int, IReadOnlyList<ModelFace>> _byHash;

    /// <summary>Creates a table from its rows, in any order.</summary>
    /// <exception cref="ArgumentException">Two faces have the same model and face number.</exception>
    public FaceTable(IEnumerable<ModelFace> faces)
    {
        _byHash = faces
            .GroupBy(face => face.Hash)
            .ToDictionary(group => group.Key, group => (IReadOnlyList<ModelFace>)group.OrderBy(face => face.Number).ToArray());
        if (_byHash.Values.Any(faces => faces.Select(face => face.Number).Distinct().Count() < faces.Count))
        {
            throw new ArgumentException("A face of a model occurs twice in the table.", nameof(faces));
        }
    }

    /// <summary>A table without rows.</summary>
    public static FaceTable Empty { get; } = new([]);

    /// <summary>All faces, ordered by model and face.</summary>
    public IEnumerable<ModelFace> Faces =>
        _byHash
            .Values.SelectMany(faces => faces)
            .OrderBy(face => face.Model, StringComparer.Ordinal)
            .ThenBy(face => face.Hash)
            .ThenBy(face => face.Number);

    /// <summary>The faces of a model in order; empty for a model that is not in the table.</summary>
    public IReadOnlyList<ModelFace> Of(int hash) => _byHash.TryGetValue(hash, out IReadOnlyList<ModelFace>? faces) ? faces : None;

    /// <summary>The faces of a model by its name, or by its hash as 0xXXXXXXXX.</summary>
    public IReadOnlyList<ModelFace> Of(string model) => Of(ModelHash.TryParse(model, out int hash) ? hash : ModelHash.Of(model));

    /// <summary>
    /// This table with the models of another one in place of its own: a user's measurements take precedence over the shipped table.
    /// </summary>
    public FaceTable OverriddenBy(FaceTable other)
    {
        if (other is null)
        {
            throw new ArgumentNullException(nameof(other));
        }

        return new FaceTable(Faces.Where(face => !other._byHash.ContainsKey(face.Hash)).Concat(other.Faces));
    }
}
