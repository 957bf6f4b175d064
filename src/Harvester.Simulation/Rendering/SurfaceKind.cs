namespace Harvester.Simulation.Rendering;

/// <summary>What the surface of a mesh is, as the ground truth of class maps. Entities are known by their handles instead.</summary>
public enum SurfaceKind : byte
{
    /// <summary>Not stated.</summary>
    None,

    /// <summary>Asphalt or the packed earth of an unpaved road.</summary>
    Road,

    /// <summary>Pavement with its kerb, and the kerbs of traffic islands.</summary>
    Pavement,

    /// <summary>Paint on a road.</summary>
    Marking,

    /// <summary>A building, a bridge, or a wall.</summary>
    Building,

    /// <summary>A tree or bush.</summary>
    Vegetation,

    /// <summary>Grass, soil, sand or rock.</summary>
    Terrain,

    /// <summary>The post of a street lamp with its arm and lamp.</summary>
    Pole,

    /// <summary>A parapet or railing.</summary>
    Fence,

    /// <summary>A rider of a two-wheeler.</summary>
    Person,

    /// <summary>Something else, such as a bench.</summary>
    Thing,

    /// <summary>The sky: nothing is there.</summary>
    Sky,
}
