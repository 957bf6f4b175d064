namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>
/// Arithmetic on one integer or on a vector of integers, for code that is written once for both. Implemented by empty structs, which cost
/// nothing.
/// </summary>
/// <typeparam name="T">An integer of 32 bits, or a vector of them.</typeparam>
internal interface ILanes<T>
{
    T Sum(T left, T right);

    T Difference(T left, T right);

    T Product(T value, int factor);

    T ShiftedLeft(T value, int bits);

    /// <summary>The value divided by 2 to the power of the bits, rounded half up.</summary>
    T Rounded(T value, int bits);
}
