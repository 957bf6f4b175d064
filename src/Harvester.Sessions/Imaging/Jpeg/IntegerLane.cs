namespace Harvester.Sessions.Imaging.Jpeg;

/// <summary>Arithmetic on one integer.</summary>
internal readonly struct IntegerLane : ILanes<int>
{
    public int Sum(int left, int right) => left + right;

    public int Difference(int left, int right) => left - right;

    public int Product(int value, int factor) => value * factor;

    public int ShiftedLeft(int value, int bits) => value << bits;

    public int Rounded(int value, int bits) => (value + (1 << (bits - 1))) >> bits;
}
