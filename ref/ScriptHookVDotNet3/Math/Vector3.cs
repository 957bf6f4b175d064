namespace GTA.Math;

/// <summary>A vector of the game, single precision.</summary>
public struct Vector3
{
    /// <summary>First component.</summary>
    public float X;

    /// <summary>Second component.</summary>
    public float Y;

    /// <summary>Third component.</summary>
    public float Z;

    /// <summary>Makes a vector.</summary>
    public Vector3(float x, float y, float z)
    {
        X = x;
        Y = y;
        Z = z;
    }
}
