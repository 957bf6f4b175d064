namespace Harvester.Exports.Formats.NuScenes;

/// <summary>A table of nuScenes, or another file about all scenes, which is written scene by scene.</summary>
/// <param name="name">Name of its file, without the extension.</param>
internal abstract class NuScenesTable(string name)
{
    /// <summary>Name of its file, without the extension.</summary>
    public string Name { get; } = name;

    /// <summary>Writes what a scene adds.</summary>
    public abstract void Add(TextWriter writer, NuScenesScene scene);

    /// <summary>Writes what follows the last scene.</summary>
    public abstract void End(TextWriter writer);
}
