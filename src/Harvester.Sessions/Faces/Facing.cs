namespace Harvester.Sessions.Faces;

/// <summary>The direction in which a face looks, in the model's frame (x right, y forward). In files: -y, +y, -x, +x.</summary>
public enum Facing
{
    /// <summary>Towards -y of the model: the direction of the game's signs and traffic lights, as far as is known.</summary>
    Back,

    /// <summary>Towards +y of the model.</summary>
    Front,

    /// <summary>Towards -x of the model.</summary>
    Left,

    /// <summary>Towards +x of the model.</summary>
    Right,
}
