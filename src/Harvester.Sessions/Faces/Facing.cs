namespace Harvester.Sessions.Faces;

/// <summary>The side of a model towards which a face looks, in the model's frame (x right, y forward). In files: -y, +y, -x, +x.</summary>
public enum Facing
{
    /// <summary>Backward: where signs and traffic lights of the game look, as far as is known.</summary>
    Back,

    /// <summary>Towards +y of the model.</summary>
    Front,

    /// <summary>Towards -x of the model.</summary>
    Left,

    /// <summary>Towards +x of the model.</summary>
    Right,
}
