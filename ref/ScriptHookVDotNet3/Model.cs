namespace GTA;

/// <summary>A model by its hash.</summary>
public struct Model
{
    /// <summary>Names a model by its hash.</summary>
    public Model(int hash) => Hash = hash;

    /// <summary>The hash of the model's name.</summary>
    public int Hash { get; }
}
