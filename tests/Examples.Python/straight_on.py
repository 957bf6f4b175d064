"""A model that takes every picture for the middle of a lane of 4 m on an empty road."""


def predict(image):
    assert (len(image), len(bytes(image[0]))) == (210, 280 * 3), "not the picture that the bridge promises"
    return [0, -7, 3.5, 7, 75, 75, -9.5, -2, 2, 9.5, 75, 75, 75]
